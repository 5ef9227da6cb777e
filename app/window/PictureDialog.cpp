// SPDX-License-Identifier: MIT
#include "app/window/PictureDialog.h"

#include <QtCore/QSettings>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QPushButton>

#include "app/pictures/PictureFormats.h"
#include "app/window/PassFields.h"
#include "app/window/PictureSizeFields.h"
#include "widgets/forms/NumberBox.h"

namespace crowd::app {

namespace {

const QString kPictureLens = QStringLiteral("picture/depthOfField");
const QString kPictureFStop = QStringLiteral("picture/fStop");
const QString kPictureTransparent = QStringLiteral("picture/transparent");

} // namespace

PictureDialog::PictureDialog(glm::ivec2 view, const model::Camera& camera,
                             std::optional<double> selectedDepth, QWidget* parent)
    : QDialog(parent), m_size(new PictureSizeFields(view, kMostPixelsASide, 1,
                                                    QStringLiteral("picture/size"), this)),
      m_transparent(new QCheckBox(this)), m_hasLens(new QCheckBox(this)),
      m_focuses(new QComboBox(this)), m_focus(new widgets::NumberBox(this)),
      m_fStop(new widgets::NumberBox(this)),
      m_passes(new PassFields(QStringLiteral("picture/passes"), this))
{
    setWindowTitle(tr("Save Picture"));
    m_transparent->setObjectName(QStringLiteral("pictureTransparent"));
    m_transparent->setText(tr("Transparent background"));
    m_transparent->setToolTip(
        tr("Without sky and ground plane, to be laid over something else. Not as JPEG."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("Save…"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &PictureDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PictureDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Size"), m_size);
    form->addRow(QString(), m_transparent);
    addLens(*form, camera, selectedDepth);
    form->addRow(tr("Passes"), m_passes);
    form->addRow(buttons);
    m_transparent->setChecked(QSettings().value(kPictureTransparent).toBool());
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

PicturePasses PictureDialog::passes() const
{
    return m_passes->chosen();
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
    return m_size->chosen();
}

bool PictureDialog::isTransparent() const
{
    return m_transparent->isChecked();
}

void PictureDialog::accept()
{
    QSettings settings;
    m_size->remember();
    settings.setValue(kPictureTransparent, m_transparent->isChecked());
    settings.setValue(kPictureLens, m_hasLens->isChecked());
    settings.setValue(kPictureFStop, m_fStop->value());
    m_passes->remember();
    QDialog::accept();
}

} // namespace crowd::app
