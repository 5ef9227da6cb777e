// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleCommands.h"

#include <algorithm>

#include <QtGui/QAction>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "model/rules/OpenChoices.h"
#include "widgets/actions/OwnKeys.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/state/ShownTake.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::Rule;

namespace {

QToolButton* ruleButton(QWidget* parent, const char* name)
{
    auto* made = new QToolButton(parent);
    made->setObjectName(QLatin1String(name));
    made->setAutoRaise(true);
    return made;
}

} // namespace

RuleCommands::RuleCommands(EditorState& state, QWidget& list, QObject* parent)
    : QObject(parent), m_state(state), m_list(list)
{
    m_duplicate =
        makeAction("ruleDuplicate", tr("Duplicate"), tr("Ctrl+D"), &RuleCommands::duplicateRule);
    m_duplicate->setIcon(iconNamed("copy"));
    m_duplicate->setToolTip(tr("Duplicate the rule"));
    m_remove =
        makeAction("ruleDelete", tr("Delete"), QKeySequence::Delete, &RuleCommands::removeRule);
    m_remove->setIcon(iconNamed("delete"));
    m_remove->setToolTip(tr("Delete the rule"));
    m_switch = makeAction("ruleSwitch", tr("Disable"), {}, &RuleCommands::switchRule);
    m_moveUp = makeAction("ruleUp", tr("Move Up"), tr("Alt+Up"), &RuleCommands::moveUp);
    m_moveDown = makeAction("ruleDown", tr("Move Down"), tr("Alt+Down"), &RuleCommands::moveDown);
    m_try = makeAction("ruleTry", tr("Test on Selected"), tr("Ctrl+T"), &RuleCommands::tryRule);
    m_try->setIcon(iconNamed("rule-test"));
    m_try->setToolTip(tr("Test the rule on the selected characters, or on all, while it plays"));
    keepKeysOfOwnActions(m_list);
}

QAction* RuleCommands::makeAction(const char* name, const QString& text, const QKeySequence& keys,
                                  void (RuleCommands::*run)())
{
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, run);
    m_list.addAction(action);
    return action;
}

QWidget* RuleCommands::makeButtons(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    QToolButton* add = ruleButton(box, "addRule");
    add->setIcon(iconNamed("add"));
    add->setText(tr("Add"));
    add->setToolTip(tr("Add a rule, or a ready-made set of rules"));
    add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(add);
    connect(menu->addAction(tr("A New Rule")), &QAction::triggered, this, &RuleCommands::addRule);
    menu->addSeparator();
    for (int i = 0; i < static_cast<int>(model::RuleSet::Count); ++i) {
        const auto set = static_cast<model::RuleSet>(i);
        connect(menu->addAction(ruleSetName(set)), &QAction::triggered, this,
                [this, set] { addSet(set); });
    }
    add->setMenu(menu);
    row->addWidget(add);
    const std::pair<const char*, QAction*> buttons[]{
        {"duplicateRule", m_duplicate}, {"removeRule", m_remove}, {"tryRule", m_try}};
    for (const auto& [name, action] : buttons) {
        QToolButton* made = ruleButton(box, name);
        made->setDefaultAction(action);
        row->addWidget(made);
    }
    row->addStretch(1);
    return box;
}

void RuleCommands::enable()
{
    const auto& rules = m_state.scene().rules;
    const Rule* rule = current();
    for (QAction* action : {m_duplicate, m_remove, m_switch, m_try}) {
        action->setEnabled(rule != nullptr);
    }
    m_moveUp->setEnabled(rule != nullptr && rule != &rules.front());
    m_moveDown->setEnabled(rule != nullptr && rule != &rules.back());
    m_switch->setText(rule == nullptr || rule->isEnabled ? tr("Disable") : tr("Enable"));
}

void RuleCommands::fill(QMenu& menu) const
{
    menu.addActions({m_duplicate, m_remove, m_switch});
    menu.addSeparator();
    menu.addActions({m_moveUp, m_moveDown});
    menu.addSeparator();
    menu.addAction(m_try);
}

const Rule* RuleCommands::current() const
{
    const auto& rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    return found == rules.end() ? nullptr : &*found;
}

void RuleCommands::setRules(std::vector<Rule> rules, const QString& undoText)
{
    m_state.document().edit(undoText,
                            [&](model::SceneEdit& edit) { edit.setRules(std::move(rules)); });
}

void RuleCommands::change(const Change& apply)
{
    std::vector<Rule> rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    if (found == rules.end()) {
        return;
    }
    const Rule before = *found;
    apply(*found);
    const Rule after = *found;
    const int others = model::fillOpenChoices(rules, before, after, m_state.scene().paths);
    setRules(std::move(rules), tr("Change a rule"));
    if (others > 0) {
        m_state.showStatus(
            tr("Chosen in %n other rule(s) too, where it was still open", nullptr, others));
    }
}

void RuleCommands::reorder(std::span<const model::RuleId> order)
{
    const auto& all = m_state.scene().rules;
    std::vector<Rule> rules;
    for (const model::RuleId id : order) {
        const auto found = std::ranges::find(all, id, &Rule::id);
        if (found != all.end()) {
            rules.push_back(*found);
        }
    }
    if (rules.size() == all.size()) {
        setRules(std::move(rules), tr("Reorder the rules"));
    }
}

/// "New rule", "New rule 2": what they log is told apart.
QString RuleCommands::freeRuleName() const
{
    const auto isTaken = [this](const QString& name) {
        return std::ranges::any_of(m_state.scene().rules, [&name](const Rule& rule) {
            return rule.name == name.toStdString();
        });
    };
    QString name = tr("New rule");
    for (int number = 2; isTaken(name); ++number) {
        name = tr("New rule %1").arg(number);
    }
    return name;
}

void RuleCommands::addRule()
{
    std::vector<Rule> made(1);
    made.front().name = freeRuleName().toStdString();
    made.front().actions.emplace_back(); // it does nothing until its event and a clip are chosen
    made.front().yields = model::RuleYield::Anybody;
    model::giveIds(made, m_state.scene());
    m_current = made.front().id;
    std::vector<Rule> rules = m_state.scene().rules;
    rules.push_back(made.front());
    setRules(std::move(rules), tr("Add a rule"));
}

void RuleCommands::addSet(model::RuleSet set)
{
    std::vector<Rule> made = model::rulesOf(set, m_state.scene());
    model::giveIds(made, m_state.scene());
    m_current = made.front().id;
    // The event brush is ready for it.
    const auto listens = std::ranges::find_if(made, [](const Rule& rule) {
        return rule.trigger.as<model::triggers::Event>() != nullptr;
    });
    if (listens != made.end()) {
        const auto* event = listens->trigger.as<model::triggers::Event>();
        model::BrushSettings brush = m_state.brush(model::BrushKind::Event);
        brush.as<model::EventSettings>().name = event->event;
        m_state.setBrush(brush);
    }
    std::vector<model::Cue> cues = model::cuesWith(set, made, m_state.scene());
    std::vector<Rule> rules = m_state.scene().rules;
    rules.insert(rules.end(), made.begin(), made.end());
    m_state.document().edit(tr("Add rules: %1").arg(ruleSetName(set)), [&](model::SceneEdit& edit) {
        edit.setRules(std::move(rules));
        edit.setCues(std::move(cues));
    });
}

void RuleCommands::duplicateRule()
{
    if (const Rule* rule = current()) {
        std::vector<Rule> made{*rule};
        model::giveIds(made, m_state.scene());
        std::vector<Rule> rules = m_state.scene().rules;
        const auto at = std::ranges::find(rules, m_current, &Rule::id);
        m_current = made.front().id;
        rules.insert(at + 1, made.front());
        setRules(std::move(rules), tr("Duplicate a rule"));
    }
}

void RuleCommands::removeRule()
{
    std::vector<Rule> rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    if (found == rules.end()) {
        return;
    }
    const auto next = rules.erase(found);
    m_current = rules.empty() ? 0 : (next == rules.end() ? rules.back().id : next->id);
    setRules(std::move(rules), tr("Delete a rule"));
}

void RuleCommands::switchRule()
{
    change([](Rule& rule) { rule.isEnabled = !rule.isEnabled; });
}

void RuleCommands::moveRule(std::ptrdiff_t by)
{
    std::vector<Rule> rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    const std::ptrdiff_t to = found - rules.begin() + by;
    if (found == rules.end() || to < 0 || to >= std::ssize(rules)) {
        return;
    }
    std::iter_swap(found, rules.begin() + to);
    setRules(std::move(rules), tr("Reorder the rules"));
}

void RuleCommands::moveUp()
{
    moveRule(-1);
}

void RuleCommands::moveDown()
{
    moveRule(1);
}

/// Lets what a rule waits for happen now.
void RuleCommands::tryRule()
{
    const Rule* rule = current();
    const auto* trigger = rule != nullptr ? rule->trigger.as<model::triggers::Event>() : nullptr;
    if (trigger == nullptr) {
        m_state.showStatus(tr("Choose a rule that begins with an event to try it."));
        return;
    }
    if (saysThatTakeIsShown(m_state)) {
        return;
    }
    if (!m_state.session().isRunning()) {
        m_state.showStatus(tr("Press Play first: rules act while it plays."));
        return;
    }
    const auto all = m_state.scene().population.ids();
    const auto ids = m_state.selection().isEmpty() ? all : m_state.selection().ids();
    model::EventSettings event = m_state.brush(model::BrushKind::Event).as<model::EventSettings>();
    event.name = trigger->event;
    m_state.session().send(event, ids);
}

} // namespace crowd::widgets
