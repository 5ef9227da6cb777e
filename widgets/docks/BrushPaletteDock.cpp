// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushPaletteDock.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QToolButton>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kColumns = 4;
constexpr int kIconSize = 30;

} // namespace

BrushPaletteDock::BrushPaletteDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Brushes"), "brushPalette", parent), m_state(state)
{
    auto* content = new QWidget(this);
    auto* grid = new QGridLayout(content);
    grid->setSpacing(4);
    int index = 0;
    for (const ToolInfo& info : toolTable()) {
        auto* button = new QToolButton(content);
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
        grid->addWidget(button, index / kColumns, index % kColumns);
        ++index;
    }
    grid->setRowStretch(index / kColumns + 1, 1);
    setWidget(content);
    connect(&m_state, &EditorState::toolChanged, this, &BrushPaletteDock::refresh);
    refreshIcons();
    refresh();
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
