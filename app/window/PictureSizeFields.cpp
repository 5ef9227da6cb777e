// SPDX-License-Identifier: MIT
#include "app/window/PictureSizeFields.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QSettings>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QVBoxLayout>

namespace crowd::app {

namespace {

constexpr int kLeastPixels = 16;
const QString kProportionsKey = QStringLiteral("pictures/keepsProportions");

QSpinBox* pixelField(const char* name, int most, QWidget* parent)
{
    auto* box = new QSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setRange(kLeastPixels, most);
    return box;
}

int wholeSteps(int pixels, int step)
{
    return pixels - pixels % step;
}

} // namespace

PictureSizeFields::PictureSizeFields(glm::ivec2 view, int mostPixelsASide, int step,
                                     const QString& settingsKey, QWidget* parent)
    : QWidget(parent), m_step(step), m_settingsKey(settingsKey), m_sizes(new QComboBox(this)),
      m_width(pixelField("pictureWidth", mostPixelsASide, this)),
      m_height(pixelField("pictureHeight", mostPixelsASide, this)),
      m_proportions(new QCheckBox(tr("Keep proportions"), this))
{
    m_sizes->setObjectName(QStringLiteral("pictureSizes"));
    m_sizes->addItem(tr("As in the window"),
                     QSize(wholeSteps(view.x, step), wholeSteps(view.y, step)));
    m_sizes->addItem(tr("Full HD"), QSize(1920, 1080));
    m_sizes->addItem(tr("4K"), QSize(3840, 2160));
    m_sizes->addItem(tr("8K"), QSize(7680, 4320));
    m_sizes->addItem(tr("Square"), QSize(2048, 2048));
    m_sizes->addItem(tr("Another size"), QSize());
    auto* pixels = new QHBoxLayout;
    pixels->addWidget(m_width);
    pixels->addWidget(new QLabel(tr("×"), this));
    pixels->addWidget(m_height);
    pixels->addWidget(new QLabel(tr("pixels"), this));
    pixels->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_sizes);
    layout->addLayout(pixels);
    layout->addWidget(m_proportions);
    connect(m_sizes, &QComboBox::currentIndexChanged, this, &PictureSizeFields::chooseSize);
    for (QSpinBox* box : {m_width, m_height}) {
        box->setSingleStep(step);
        connect(box, &QSpinBox::valueChanged, this, [this, box] { changeTheOther(box); });
        connect(box, &QSpinBox::editingFinished, this,
                [box, step] { box->setValue(wholeSteps(box->value(), step)); });
    }
    m_proportions->setObjectName(QStringLiteral("keepProportions"));
    m_proportions->setToolTip(tr("A new width gives a new height, and the other way round"));
    connect(m_proportions, &QCheckBox::toggled, this, [this] {
        m_widthToHeight = static_cast<double>(m_width->value()) / m_height->value();
    });
    chooseSize(0);
    const QSize last = QSettings().value(m_settingsKey).toSize(); // invalid: as the window
    if (last.isValid()) {
        m_width->setValue(last.width());
        m_height->setValue(last.height());
    }
    m_proportions->setChecked(QSettings().value(kProportionsKey).toBool());
}

glm::ivec2 PictureSizeFields::chosen() const
{
    return {wholeSteps(m_width->value(), m_step), wholeSteps(m_height->value(), m_step)};
}

void PictureSizeFields::remember() const
{
    const bool isWindow = m_sizes->currentIndex() == 0;
    QSettings().setValue(kProportionsKey, m_proportions->isChecked());
    QSettings().setValue(m_settingsKey,
                         isWindow ? QSize() : QSize(m_width->value(), m_height->value()));
}

void PictureSizeFields::chooseSize(int index)
{
    const QSize size = m_sizes->itemData(index).toSize();
    if (!size.isValid()) {
        return; // the artist's own
    }
    const QSignalBlocker width(m_width);
    const QSignalBlocker height(m_height);
    m_width->setValue(size.width());
    m_height->setValue(size.height());
    m_widthToHeight = static_cast<double>(m_width->value()) / m_height->value();
}

void PictureSizeFields::changeTheOther(const QSpinBox* changed)
{
    if (m_proportions->isChecked()) {
        QSpinBox* other = changed == m_width ? m_height : m_width;
        const double pixels = changed == m_width ? m_width->value() / m_widthToHeight
                                                 : m_height->value() * m_widthToHeight;
        const QSignalBlocker blocker(other);
        const double most = other->maximum();
        const auto whole = static_cast<int>(std::lround(std::min(pixels, most)));
        other->setValue(wholeSteps(whole, m_step));
    }
    noteOwnSize();
}

/// The list shows the name of the size that stands in the fields.
void PictureSizeFields::noteOwnSize()
{
    const QSignalBlocker blocker(m_sizes);
    const int found = m_sizes->findData(QSize(m_width->value(), m_height->value()));
    m_sizes->setCurrentIndex(found >= 0 ? found : m_sizes->count() - 1);
}

} // namespace crowd::app
