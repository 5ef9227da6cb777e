// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <QtCore/QObject>
#include <QtGui/QAction>
#include <QtGui/QKeySequence>

namespace crowd::widgets {

/// An action as data. Texts are marked with QT_TRANSLATE_NOOP("Actions", …).
struct ActionSpec
{
    const char* id;       ///< stable: settings and tests name it
    const char* text;     ///< as in a menu, with its mnemonic
    const char* icon;     ///< resources/icons/NAME.svg
    const char* shortcut; ///< default, portable text; alternatives separated by "; "
    const char* tip;      ///< one sentence for tool tip and status bar
    bool isCheckable = false;
};

/// The one place where the window's actions live: menus, tool bars and preferences are built from
/// it. Owns the QActions; they are added to `window` so that shortcuts work everywhere in it.
class ActionRegistry : public QObject
{
    Q_OBJECT

public:
    explicit ActionRegistry(QWidget* window);

    /// Adds an action that calls `run` with its checked state.
    QAction* add(const ActionSpec& spec, std::function<void(bool)> run);
    /// The action of an id that was added.
    [[nodiscard]] QAction* action(const std::string& id) const;
    [[nodiscard]] const std::vector<ActionSpec>& specs() const { return m_specs; }
    [[nodiscard]] static QList<QKeySequence> defaultShortcuts(const ActionSpec& spec);

    /// Replaces the shortcut of an action and remembers it in the settings; back to the default
    /// when it equals that.
    void setShortcut(const std::string& id, const QKeySequence& keys);
    /// The action that has these keys, null if none.
    [[nodiscard]] QAction* actionWithShortcut(const QKeySequence& keys) const;
    void resetShortcuts();

private:
    [[nodiscard]] const ActionSpec& spec(const std::string& id) const;
    void loadShortcut(const ActionSpec& spec, QAction& action) const;
    static void setTexts(const ActionSpec& spec, QAction& action);

    QWidget* m_window;
    std::vector<ActionSpec> m_specs;
    std::map<std::string, QAction*> m_actions;
};

} // namespace crowd::widgets
