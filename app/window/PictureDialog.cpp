// SPDX-License-Identifier: MIT
#include "app/window/PictureDialog.h"

#include <QtCore/QSettings>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

namespace crowd::app {

namespace {

const QString kPictureSize = QStringLiteral("picture/size"); ///< invalid: as the window
const QString kPictureLens = QStringLiteral("picture/depthOfField");
const QString kPictureFStop = QStringLiteral("picture/fStop");
const QString kPictureTransparent = QStringLiteral("picture/transparent");
constexpr int kLeastPixels = 16;
constexpr int kMostPixels = 8192;

QSpinBox* pixelField(const char* name, QWidget* parent)
{
    auto* box = new QSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setRange(kLeastPixels, kMostPixels);
    return box;
}

} // namespace

PictureDialog::PictureDialog(glm::ivec2 view, const model::Camera& camera,
                             std::optional<double> selectedDepth, QWidget* parent)
    : QDialog(parent), m_sizes(new QComboBox(this)), m_width(pixelField("pictureWidth", this)),
      m_height(pixelField("pictureHeight", this)), m_transparent(new QCheckBox(this)),
      m_hasLens(new QCheckBox(this)), m_focuses(new QComboBox(this)),
      m_focus(new QDoubleSpinBox(this)), m_fStop(new QDoubleSpinBox(this))
{
    setWindowTitle(tr("Save Picture"));
    m_sizes->setObjectName(QStringLiteral("pictureSizes"));
    m_sizes->addItem(tr("As in the window"), QSize(view.x, view.y));
    m_sizes->addItem(tr("Full HD"), QSize(1920, 1080));
    m_sizes->addItem(tr("4K"), QSize(3840, 2160));
    m_sizes->addItem(tr("Square"), QSize(2048, 2048));
    m_sizes->addItem(tr("Another size"), QSize());
    m_transparent->setObjectName(QStringLiteral("pictureTransparent"));
    m_transparent->setText(tr("Transparent background"));
    m_transparent->setToolTip(
        tr("Without sky and ground plane, to be laid over something else. Not as JPEG."));
    auto* pixels = new QHBoxLayout;
    pixels->addWidget(m_width);
    pixels->addWidget(new QLabel(tr("×"), this));
    pixels->addWidget(m_height);
    pixels->addWidget(new QLabel(tr("pixels"), this));
    pixels->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("Save…"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &PictureDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PictureDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Size"), m_sizes);
    form->addRow(QString(), pixels);
    form->addRow(QString(), m_transparent);
    addLens(*form, camera, selectedDepth);
    form->addRow(buttons);
    connect(m_sizes, &QComboBox::currentIndexChanged, this, &PictureDialog::chooseSize);
    for (QSpinBox* box : {m_width, m_height}) {
        connect(box, &QSpinBox::valueChanged, this, &PictureDialog::noteOwnSize);
    }
    const QSettings settings;
    const QSize last = settings.value(kPictureSize).toSize();
    m_transparent->setChecked(settings.value(kPictureTransparent).toBool());
    chooseSize(0);
    if (last.isValid()) {
        m_width->setValue(last.width());
        m_height->setValue(last.height());
    }
}

void PictureDialog::addLens(QFormLayout& form, const model::Camera& camera,
                            std::optional<double> selectedDepth)
{
    const bool canBe = camera.projection == model::Projection::Perspective;
    m_hasLens->setObjectName(QStringLiteral("pictureLens"));
    m_hasLens->setText(tr("Depth of field"));
    m_hasLens->setToolTip(canBe
                              ? tr("What is nearer or farther than a distance is soft, as through "
                                   "a lens. Drawing takes longer.")
                              : tr("An orthographic camera has no lens: everything is sharp."));
    m_focuses->setObjectName(QStringLiteral("pictureFocuses"));
    m_focuses->addItem(tr("What the camera turns around"),
                       static_cast<double>(camera.pivotDistance));
    if (selectedDepth) {
        m_focuses->addItem(tr("Who is selected"), *selectedDepth);
    }
    m_focuses->addItem(tr("Another distance"), QVariant());
    m_focus->setObjectName(QStringLiteral("pictureFocus"));
    m_focus->setRange(kLeastFocus, kMostFocus);
    m_focus->setSuffix(tr(" m"));
    m_fStop->setObjectName(QStringLiteral("pictureFStop"));
    m_fStop->setRange(kLeastFStop, kMostFStop);
    m_fStop->setSingleStep(0.1);
    m_fStop->setToolTip(
        tr("The opening of the lens: the smaller the number, the less is sharp. 1 to "
           "8 as of a camera for photographs, 0.1 as of a model on a table"));
    form.addRow(QString(), m_hasLens);
    form.addRow(tr("Sharp"), m_focuses);
    form.addRow(QString(), m_focus);
    form.addRow(tr("F-stop"), m_fStop);
    const QSettings settings;
    m_fStop->setValue(settings.value(kPictureFStop, kUsualFStop).toDouble());
    const auto enable = [this, canBe] {
        for (QWidget* each : {static_cast<QWidget*>(m_focuses), static_cast<QWidget*>(m_focus),
                              static_cast<QWidget*>(m_fStop)}) {
            each->setEnabled(canBe && m_hasLens->isChecked());
        }
    };
    connect(m_hasLens, &QCheckBox::toggled, this, enable);
    connect(m_focuses, &QComboBox::currentIndexChanged, this, &PictureDialog::chooseFocus);
    connect(m_focus, &QDoubleSpinBox::valueChanged, this, &PictureDialog::noteOwnFocus);
    m_hasLens->setEnabled(canBe);
    m_hasLens->setChecked(canBe && settings.value(kPictureLens).toBool());
    enable();
    m_focuses->setCurrentIndex(selectedDepth ? 1 : 0);
    chooseFocus(m_focuses->currentIndex());
}

void PictureDialog::chooseFocus(int index)
{
    const QVariant metres = m_focuses->itemData(index);
    if (metres.isValid()) {
        const QSignalBlocker blocker(m_focus);
        m_focus->setValue(metres.toDouble());
    }
}

void PictureDialog::noteOwnFocus()
{
    const QSignalBlocker blocker(m_focuses);
    m_focuses->setCurrentIndex(m_focuses->count() - 1);
}

LensWish PictureDialog::lens() const
{
    if (!m_hasLens->isChecked()) {
        return {};
    }
    return {m_focus->value(), m_fStop->value()};
}

glm::ivec2 PictureDialog::chosenSize() const
{
    return {m_width->value(), m_height->value()};
}

bool PictureDialog::isTransparent() const
{
    return m_transparent->isChecked();
}

void PictureDialog::chooseSize(int index)
{
    const QSize size = m_sizes->itemData(index).toSize();
    if (!size.isValid()) {
        return; // the artist's own
    }
    const QSignalBlocker width(m_width);
    const QSignalBlocker height(m_height);
    m_width->setValue(size.width());
    m_height->setValue(size.height());
}

/// The list shows the name of the size that stands in the fields.
void PictureDialog::noteOwnSize()
{
    const QSignalBlocker blocker(m_sizes);
    const int found = m_sizes->findData(QSize(m_width->value(), m_height->value()));
    m_sizes->setCurrentIndex(found >= 0 ? found : m_sizes->count() - 1);
}

void PictureDialog::accept()
{
    QSettings settings;
    const bool isWindow = m_sizes->currentIndex() == 0;
    settings.setValue(kPictureSize,
                      isWindow ? QSize() : QSize(m_width->value(), m_height->value()));
    settings.setValue(kPictureTransparent, m_transparent->isChecked());
    settings.setValue(kPictureLens, m_hasLens->isChecked());
    settings.setValue(kPictureFStop, m_fStop->value());
    QDialog::accept();
}

} // namespace crowd::app
