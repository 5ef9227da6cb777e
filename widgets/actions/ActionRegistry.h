// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QFlags>
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

/// What an action's state can depend on.
enum class ActionInput : unsigned {
    History = 1U << 0U,
    Selection = 1U << 1U,
    Paths = 1U << 2U, ///< places and paths that are being worked on
    Tool = 1U << 3U,
    Brush = 1U << 4U,
    View = 1U << 5U,
    Playback = 1U << 6U,
    Session = 1U << 7U,
    Script = 1U << 8U,
    Recording = 1U << 9U,
    Window = 1U << 10U, ///< full screen, panels
};
Q_DECLARE_FLAGS(ActionInputs, ActionInput)
Q_DECLARE_OPERATORS_FOR_FLAGS(ActionInputs)

/// How an action stands now: asked when one of its inputs has changed, and after it ran.
struct ActionState
{
    ActionInputs inputs;                  ///< all that the functions look at
    std::function<bool()> isEnabled = {}; ///< none: always
    std::function<bool()> isChecked = {}; ///< none: as it was clicked
    std::function<QString()> text = {};   ///< none: as its spec says
};

/// The one place where the window's actions live: menus, tool bars and preferences are built from
/// it. Owns the QActions; they are added to `window` so that shortcuts work everywhere in it.
class ActionRegistry : public QObject
{
    Q_OBJECT

public:
    explicit ActionRegistry(QWidget* window);

    /// Adds an action that calls `run` with its checked state.
    QAction* add(const ActionSpec& spec, std::function<void(bool)> run, ActionState state = {});
    /// Of the actions, those that depend on any of these follow.
    void refresh(ActionInputs changed);
    /// All texts in the language of now.
    void renewTexts();
    /// The action of an id that was added.
    [[nodiscard]] QAction* action(const std::string& id) const;
    [[nodiscard]] const std::vector<ActionSpec>& specs() const { return m_specs; }
    [[nodiscard]] static QList<QKeySequence> defaultShortcuts(const ActionSpec& spec);

    /// Replaces the shortcut of an action and remembers it in the settings; back to the default
    /// when it equals that.
    void setShortcut(const std::string& id, const QKeySequence& keys);
    /// The action that has these keys, null if none.
    [[nodiscard]] QAction* actionWithShortcut(const QKeySequence& keys) const;

private:
    [[nodiscard]] const ActionSpec& spec(const std::string& id) const;
    void loadShortcut(const ActionSpec& spec, QAction& action) const;
    static void setTexts(const ActionSpec& spec, QAction& action);
    static void refresh(const ActionState& state, QAction& action);

    QWidget* m_window;
    std::vector<ActionSpec> m_specs;
    std::map<std::string, QAction*> m_actions;
    std::vector<std::pair<ActionState, QAction*>> m_states; ///< of those that depend on something
};

} // namespace crowd::widgets
