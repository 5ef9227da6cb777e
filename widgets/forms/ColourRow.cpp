// SPDX-License-Identifier: MIT
#include "widgets/forms/ColourRow.h"

#include <utility>

#include <QtWidgets/QColorDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "widgets/forms/WrapRow.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

QColor colourOf(const model::PaintColor& color)
{
    return {color[0], color[1], color[2]};
}

model::PaintColor paintOf(const QColor& color)
{
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

} // namespace

ColourRow::ColourRow(QString title, QWidget* parent)
    : QWidget(parent), m_title(std::move(title)), m_row(new WrapRow(this)),
      m_add(new QToolButton(this))
{
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(2);
    m_add->setObjectName(QStringLiteral("addColour"));
    m_add->setIcon(iconNamed("add"));
    m_add->setAutoRaise(true);
    m_add->setToolTip(tr("Add a colour"));
    connect(m_add, &QToolButton::clicked, this, &ColourRow::add);
    m_row->addWidget(m_add);
}

void ColourRow::setColours(const Colours& colours)
{
    if (colours != m_colours || m_swatches.size() != colours.size()) {
        m_colours = colours;
        fill();
    }
}

void ColourRow::fill()
{
    while (m_swatches.size() > m_colours.size()) {
        m_swatches.back()->hide();
        m_swatches.back()->deleteLater(); // its own menu may have asked for it
        m_swatches.pop_back();
    }
    while (m_swatches.size() < m_colours.size()) {
        addSwatch(m_swatches.size());
    }
    for (std::size_t i = 0; i < m_colours.size(); ++i) {
        m_swatches[i]->setIcon(swatchIcon(colourOf(m_colours[i])));
        m_swatches[i]->setAccessibleName(colourOf(m_colours[i]).name());
    }
}

void ColourRow::addSwatch(std::size_t index)
{
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("colour"));
    button->setToolTip(tr("Click: change the colour. Right button: take it out."));
    button->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(button, &QToolButton::clicked, this, [this, index] { change(index); });
    connect(button, &QWidget::customContextMenuRequested, this,
            [this, button, index](const QPoint& at) {
                QMenu menu(this);
                menu.addAction(iconNamed("remove"), tr("Take Out"), this,
                               [this, index] { remove(index); });
                menu.exec(button->mapToGlobal(at));
            });
    m_row->insertWidget(static_cast<int>(index), button);
    m_swatches.push_back(button);
    button->show();
}

void ColourRow::change(std::size_t index)
{
    const QColor chosen = QColorDialog::getColor(colourOf(m_colours[index]), this, m_title,
                                                 QColorDialog::DontUseNativeDialog);
    if (chosen.isValid() && index < m_colours.size()) {
        m_colours[index] = paintOf(chosen);
        fill();
        Q_EMIT edited(m_colours);
    }
}

void ColourRow::remove(std::size_t index)
{
    if (index < m_colours.size()) {
        m_colours.erase(m_colours.begin() + static_cast<std::ptrdiff_t>(index));
        fill();
        Q_EMIT edited(m_colours);
    }
}

/// As the last one, to be changed.
void ColourRow::add()
{
    constexpr model::PaintColor kFirst{180, 60, 50};
    const QColor chosen =
        QColorDialog::getColor(colourOf(m_colours.empty() ? kFirst : m_colours.back()), this,
                               m_title, QColorDialog::DontUseNativeDialog);
    if (chosen.isValid()) {
        m_colours.push_back(paintOf(chosen));
        fill();
        Q_EMIT edited(m_colours);
    }
}

} // namespace crowd::widgets
