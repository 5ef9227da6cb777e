// SPDX-License-Identifier: MIT
#include "app/window/WindowBars.h"

#include <cstddef>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtCore/QSignalBlocker>
#include <QtGui/QAction>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QToolBar>

#include "app/window/DockTable.h"
#include "app/window/MainWindow.h"
#include "app/window/Mnemonics.h"
#include "app/window/TimeSlider.h"
#include "app/window/WindowActions.h"
#include "widgets/actions/ActionRegistry.h"
#include "widgets/forms/NumberBox.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

namespace {

constexpr int kToolIconSize = 22; ///< logical pixels

QString clockText(double seconds)
{
    const auto tenths = static_cast<qint64>(seconds * 10.0 + 1e-6);
    return QStringLiteral("%1:%2%3%4")
        .arg(tenths / 600)
        .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
        .arg(QLocale().decimalPoint())
        .arg(tenths % 10);
}

/// How long it has played, in minutes, seconds and tenths.
void addClock(QToolBar& bar, const widgets::Transport& transport)
{
    auto* clock = new QLabel(&bar);
    clock->setObjectName(QStringLiteral("playClock"));
    clock->setToolTip(MainWindow::tr("Time shown: minutes and seconds from the start"));
    clock->setAlignment(Qt::AlignCenter);
    clock->setMinimumWidth(clock->fontMetrics().horizontalAdvance(QStringLiteral("00:00.0")) + 8);
    const auto show = [clock](double seconds) { clock->setText(clockText(seconds)); };
    show(transport.seconds());
    QObject::connect(&transport, &widgets::Transport::timeChanged, clock, show);
    bar.addWidget(clock);
}

/// How many times faster than life it plays.
void addSpeedField(QToolBar& bar, widgets::EditorState& state, QWidget& picture)
{
    auto* speed = new widgets::NumberBox(&bar);
    speed->setObjectName(QStringLiteral("playSpeed"));
    speed->setRange(0.1, 8.0);
    speed->setSingleStep(0.1);
    speed->setDecimals(1);
    speed->setPrefix(MainWindow::tr("× "));
    speed->setToolTip(MainWindow::tr("Speed of play"));
    speed->setFocusPolicy(Qt::ClickFocus);
    speed->setKeyboardTracking(false);
    speed->setValue(state.transport().state().speed);
    bar.addWidget(speed);
    QObject::connect(speed, &QDoubleSpinBox::valueChanged, &state,
                     [&state](double value) { state.transport().setSpeed(value); });
    QObject::connect(speed, &QDoubleSpinBox::editingFinished, &picture,
                     [&picture] { picture.setFocus(); });
    QObject::connect(&state.transport(), &widgets::Transport::stateChanged, speed,
                     [speed](const widgets::TransportState& now) {
                         const QSignalBlocker blocker(speed);
                         speed->setValue(now.speed);
                     });
}

/// What shows each panel: with keys of its own where it has some.
void addPanels(QMenu& menu, const std::vector<QDockWidget*>& docks,
               const widgets::ActionRegistry& actions)
{
    for (std::size_t i = 0; i < docks.size(); ++i) {
        const char* own = dockTable()[i].action;
        menu.addAction(own != nullptr ? actions.action(own) : docks[i]->toggleViewAction());
    }
}

void addActions(QMenu& menu, std::span<const char* const> ids,
                const widgets::ActionRegistry& actions)
{
    for (const char* id : ids) {
        menu.addAction(actions.action(id));
    }
}

} // namespace

Submenus fillMenuBar(QMenuBar& bar, const widgets::ActionRegistry& actions,
                     const std::vector<QDockWidget*>& docks)
{
    Submenus submenus;
    for (const MenuSpec& spec : menuTable()) {
        QMenu* menu = bar.addMenu(QCoreApplication::translate("Menus", spec.title));
        for (const std::string id : spec.ids) {
            if (id.empty()) {
                menu->addSeparator();
            } else if (id == "@docks") {
                addPanels(*menu, docks, actions);
            } else if (id.front() == '@') {
                const SubmenuSpec& inside = submenuSpec(id);
                submenus[id] = menu->addMenu(QCoreApplication::translate("Menus", inside.title));
                addActions(*submenus[id], inside.ids, actions);
            } else {
                menu->addAction(actions.action(id));
            }
        }
    }
    setMnemonicsApart(bar.actions());
    return submenus;
}

void fillToolBar(QToolBar& bar, const widgets::ActionRegistry& actions, widgets::EditorState& state,
                 QWidget& picture)
{
    bar.setObjectName(QStringLiteral("toolBar"));
    bar.setIconSize({kToolIconSize, kToolIconSize});
    for (const std::string id : toolBarTable()) {
        if (id.empty()) {
            bar.addSeparator();
        } else {
            bar.addAction(actions.action(id));
        }
    }
    addClock(bar, state.transport());
    bar.addWidget(new TimeSlider(state, &bar));
    addSpeedField(bar, state, picture);
}

} // namespace crowd::app
