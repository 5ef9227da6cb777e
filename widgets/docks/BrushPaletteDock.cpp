// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushPaletteDock.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QToolButton>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kIconSize = 24;
constexpr int kSpacing = 3;
constexpr int kMargin = 5;

} // namespace

BrushPaletteDock::BrushPaletteDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Brushes"), "brushPalette", parent), m_state(state), m_content(new QWidget(this)),
      m_grid(new QGridLayout(m_content))
{
    m_grid->setSpacing(kSpacing);
    m_grid->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    for (const ToolInfo& info : toolTable()) {
        auto* button = new QToolButton(m_content);
        const QString name = QCoreApplication::translate("Tools", info.name);
        button->setObjectName(QLatin1String(info.stableId));
        button->setToolTip(QStringLiteral("%1  (%2)").arg(name, QLatin1String(info.shortcut)));
        button->setAccessibleName(name);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setIconSize({kIconSize, kIconSize});
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const ToolId id = info.id;
        connect(button, &QToolButton::clicked, this, [this, id] {
            m_state.setTool(id);
            refresh(); // a click on the active tool must not uncheck it
        });
        m_buttons[static_cast<std::size_t>(id)] = button;
    }
    setWidget(m_content);
    connect(&m_state, &EditorState::toolChanged, this, &BrushPaletteDock::refresh);
    refreshIcons();
    refresh();
    arrange(sizeHint().width());
}

void BrushPaletteDock::arrange(int width)
{
    const QSize cell = m_buttons.front()->sizeHint();
    const int fitting = (width - 2 * kMargin + kSpacing) / (cell.width() + kSpacing);
    const int count = static_cast<int>(m_buttons.size());
    const int columns = std::clamp(fitting, 1, count);
    if (columns == m_columns) {
        return;
    }
    m_columns = columns;
    for (int i = 0; i < count; ++i) {
        m_grid->addWidget(m_buttons[static_cast<std::size_t>(i)], i / columns, i % columns);
    }
    const int rows = (count + columns - 1) / columns;
    m_content->setFixedHeight(rows * (cell.height() + kSpacing) - kSpacing + 2 * kMargin);
    m_content->setMinimumWidth(std::min(4, count) * (cell.width() + kSpacing));
}

void BrushPaletteDock::resizeEvent(QResizeEvent* event)
{
    DockBase::resizeEvent(event);
    arrange(width());
}

void BrushPaletteDock::refresh()
{
    for (const ToolInfo& info : toolTable()) {
        m_buttons[static_cast<std::size_t>(info.id)]->setChecked(info.id == m_state.tool());
    }
}

void BrushPaletteDock::refreshIcons()
{
    for (const ToolInfo& info : toolTable()) {
        m_buttons[static_cast<std::size_t>(info.id)]->setIcon(iconNamed(info.stableId));
    }
}

void BrushPaletteDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        refreshIcons();
    }
}

} // namespace crowd::widgets
