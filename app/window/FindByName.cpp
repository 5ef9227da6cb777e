// SPDX-License-Identifier: MIT
#include "app/window/FindByName.h"

#include <set>
#include <utility>

#include <QtCore/QPointer>
#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

#include "app/window/DockTable.h"
#include "app/window/FindWords.h"
#include "app/window/MainWindow.h"
#include "widgets/actions/MenuText.h"
#include "widgets/dialogs/FindDialog.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/theme/Icons.h"

namespace crowd::app {

namespace {

using widgets::FieldForm;
using widgets::Findable;

constexpr const char* kFindAction = "find";

void showPanel(MainWindow& window, QDockWidget& dock)
{
    window.dockLayout().setHidden(false);
    dock.show();
    dock.raise();
}

Findable fromAction(QAction& action, const QString& place)
{
    Findable item{widgets::menuText(action.text()), place};
    item.keys = action.shortcut().toString(QKeySequence::NativeText);
    item.tip = action.statusTip();
    item.words = findWords(action.objectName());
    item.icon = action.icon();
    if (action.isCheckable()) {
        item.isOn = action.isChecked();
    }
    item.isApplicable = action.isEnabled();
    item.run = [target = QPointer<QAction>(&action)] {
        if (target && target->isEnabled()) { // it may have changed since it was found
            target->trigger();
        }
    };
    return item;
}

/// Collects without saying anything twice.
class Collector
{
public:
    explicit Collector(MainWindow& window) : m_window(window)
    {
        m_seen.insert(window.actions().action(kFindAction));
    }

    void addPanels()
    {
        const std::vector<QDockWidget*>& docks = m_window.docks();
        for (std::size_t i = 0; i < docks.size(); ++i) {
            const char* own = dockTable()[i].action;
            QAction* shows =
                own != nullptr ? m_window.actions().action(own) : docks[i]->toggleViewAction();
            m_seen.insert(shows);
            // Not the title: that of the brush settings names the brush.
            Findable item{widgets::menuText(docks[i]->toggleViewAction()->text()),
                          MainWindow::tr("Panel")};
            item.keys = shows->shortcut().toString(QKeySequence::NativeText);
            item.icon = widgets::iconNamed("dock");
            item.tip = MainWindow::tr("Shows the panel");
            item.words = findWords(QStringLiteral("panel-") + docks[i]->objectName());
            item.run = [this_window = QPointer<MainWindow>(&m_window),
                        dock = QPointer<QDockWidget>(docks[i])] {
                if (this_window && dock) {
                    showPanel(*this_window, *dock);
                }
            };
            m_all.push_back(std::move(item));
        }
    }

    void addMenu(QMenu& menu, const QString& place)
    {
        Q_EMIT menu.aboutToShow(); // some are filled only then
        const QList<QAction*> entries = menu.actions();
        for (QAction* entry : entries) {
            if (QMenu* inside = entry->menu()) {
                addMenu(*inside,
                        place + QStringLiteral(" › ") + widgets::menuText(inside->title()));
            } else if (!entry->isSeparator() && !entry->text().isEmpty() &&
                       m_seen.insert(entry).second) {
                m_all.push_back(fromAction(*entry, place));
            }
        }
        Q_EMIT menu.aboutToHide();
    }

    /// What is in no menu.
    void addOthers()
    {
        for (const widgets::ActionSpec& spec : m_window.actions().specs()) {
            QAction* action = m_window.actions().action(spec.id);
            if (m_seen.insert(action).second) {
                m_all.push_back(fromAction(*action, {}));
            }
        }
    }

    void addSettings()
    {
        for (QDockWidget* dock : m_window.docks()) {
            const auto forms = dock->findChildren<FieldForm*>();
            for (FieldForm* form : forms) {
                if (dock->widget() != nullptr && form->isVisibleTo(dock->widget())) {
                    addForm(*dock, *form);
                }
            }
        }
    }

    [[nodiscard]] std::vector<Findable> all() && { return std::move(m_all); }

private:
    void addForm(QDockWidget& dock, FieldForm& form)
    {
        for (const FieldForm::Setting& setting : form.settings()) {
            Findable item{setting.name, dock.windowTitle()};
            if (!setting.section.isEmpty()) {
                item.place += QStringLiteral(" › ") + setting.section;
            }
            item.tip = setting.tip;
            item.run = [this_window = QPointer<MainWindow>(&m_window),
                        panel = QPointer<QDockWidget>(&dock), into = QPointer<FieldForm>(&form),
                        row = QPointer<QWidget>(setting.row)] {
                if (this_window && panel && into && row) {
                    showPanel(*this_window, *panel);
                    into->reveal(*row);
                }
            };
            m_all.push_back(std::move(item));
        }
    }

    MainWindow& m_window;
    std::set<const QAction*> m_seen;
    std::vector<Findable> m_all;
};

} // namespace

std::vector<Findable> findables(MainWindow& window)
{
    Collector collector(window);
    // Of those that are called the same, brushes come first and panels next.
    QAction* aTool = window.actions().action("select");
    const QList<QAction*> menus = window.menuBar()->actions();
    for (const bool areTools : {true, false}) {
        for (QAction* entry : menus) {
            QMenu* menu = entry->menu();
            if (menu != nullptr && menu->actions().contains(aTool) == areTools) {
                collector.addMenu(*menu, widgets::menuText(menu->title()));
            }
        }
        if (areTools) {
            collector.addPanels();
        }
    }
    collector.addOthers();
    collector.addSettings();
    return std::move(collector).all();
}

void findByName(MainWindow& window)
{
    auto* dialog = new widgets::FindDialog(findables(window), &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &widgets::FindDialog::taken, &window, [&window](const Findable& what) {
        QTimer::singleShot(0, &window, what.run); // once the window has the keyboard again
    });
    dialog->open();
}

} // namespace crowd::app
