// SPDX-License-Identifier: MIT
#include "widgets/docks/RulesDock.h"

#include <algorithm>

#include <QtCore/QLocale>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "behavior/rules/RuleEngine.h"
#include "model/document/SceneEdit.h"
#include "widgets/docks/CueBar.h"
#include "widgets/docks/NamesForm.h"
#include "widgets/docks/RuleEditor.h"
#include "widgets/docks/RuleTexts.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::Rule;
using model::TriggerKind;

namespace {

constexpr int kCountMs = 250;
constexpr std::size_t kMaxLines = 400;
constexpr int kLeastListHeight = 34; ///< logical pixels
constexpr int kMostListHeight = 240;
constexpr QColor kProblemColor(208, 80, 64);

QToolButton* button(QWidget* parent, const char* icon, const QString& tip)
{
    auto* made = new QToolButton(parent);
    made->setIcon(iconNamed(icon));
    made->setToolTip(tip);
    made->setAutoRaise(true);
    return made;
}

} // namespace

RulesDock::RulesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Rules"), "rules", parent), m_state(state), m_list(new QListWidget(this))
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(makeButtons(content));
    layout->addWidget(new CueBar(state, content));
    m_list->setObjectName(QStringLiteral("ruleList"));
    m_list->setWordWrap(true);
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    layout->addWidget(m_list);
    m_note = new QLabel(tr("No rules yet. “Add” has ready-made ones to begin with; the event "
                           "brush (E) sets them off while it plays."),
                        content);
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    layout->addWidget(m_note);
    m_problem = new QLabel(content);
    m_problem->setObjectName(QStringLiteral("ruleProblem"));
    m_problem->setWordWrap(true);
    m_problem->setStyleSheet(QStringLiteral("color: %1").arg(kProblemColor.name()));
    layout->addWidget(m_problem);
    m_editorArea = new QWidget(content);
    auto* area = new QVBoxLayout(m_editorArea);
    area->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_editorArea);
    m_onlySelected = new QCheckBox(tr("Log only the selected people"), content);
    layout->addWidget(m_onlySelected);
    m_log = new QPlainTextEdit(content);
    m_log->setObjectName(QStringLiteral("ruleLog"));
    m_log->setReadOnly(true);
    m_log->setPlaceholderText(tr("What fired, while it plays"));
    m_log->setMinimumHeight(50);
    layout->addWidget(m_log, 1);
    layout->addWidget(new NamesForm(state, content));
    setScrolledContent(content);

    m_fit.setSingleShot(true);
    m_fit.setInterval(0);
    connect(&m_fit, &QTimer::timeout, this, &RulesDock::fitList);
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, [this] {
        rebuildList();
        rebuildEditor();
    });
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (std::holds_alternative<model::RulesChanged>(change) ||
                    std::holds_alternative<model::PathsChanged>(change) ||
                    std::holds_alternative<model::TemplatesChanged>(change) ||
                    std::holds_alternative<model::SceneReplaced>(change)) {
                    m_rebuild.start();
                }
            });
    m_counting.setInterval(kCountMs);
    connect(&m_counting, &QTimer::timeout, this, &RulesDock::refreshCounts);
    connect(&m_state.session(), &SessionControl::stateChanged, this, [this] {
        if (m_state.session().isRunning()) {
            m_lines.clear();
            m_counting.start();
        } else {
            m_counting.stop();
        }
        refreshCounts();
    });
    connect(&m_state.session(), &SessionControl::problemsChanged, this, &RulesDock::showProblems);
    connect(m_onlySelected, &QCheckBox::clicked, this, &RulesDock::showLog);
    connect(&m_state.selection(), &Selection::changed, this, &RulesDock::showLog);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (!m_isFilling) {
            m_current = item == nullptr ? 0 : item->data(kIdRole).toUInt();
            rebuildEditor();
        }
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_isFilling) {
            m_current = item->data(kIdRole).toUInt();
            const bool isOn = item->checkState() == Qt::Checked;
            change([isOn](Rule& rule) { rule.isEnabled = isOn; });
        }
    });
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &RulesDock::takeOrder);
    rebuildList();
    rebuildEditor();
}

/// As high as its rules, so that the chosen one is built right below.
void RulesDock::fitList()
{
    if (m_list->count() == 0) {
        return;
    }
    const int top = m_list->visualItemRect(m_list->item(0)).top();
    const int bottom = m_list->visualItemRect(m_list->item(m_list->count() - 1)).bottom();
    m_list->setFixedHeight(std::clamp(bottom - top + 4, kLeastListHeight, kMostListHeight));
}

void RulesDock::resizeEvent(QResizeEvent* event)
{
    DockBase::resizeEvent(event);
    m_fit.start(); // sentences break elsewhere
}

QWidget* RulesDock::makeButtons(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    auto* add = button(box, "add", tr("Add a rule, or a ready-made set of rules"));
    add->setObjectName(QStringLiteral("addRule"));
    add->setText(tr("Add"));
    add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(add);
    connect(menu->addAction(tr("A New Rule")), &QAction::triggered, this, &RulesDock::addRule);
    menu->addSeparator();
    for (int i = 0; i < static_cast<int>(model::RuleSet::Count); ++i) {
        const auto set = static_cast<model::RuleSet>(i);
        connect(menu->addAction(ruleSetName(set)), &QAction::triggered, this,
                [this, set] { addSet(set); });
    }
    add->setMenu(menu);
    row->addWidget(add);
    auto* copy = button(box, "group", tr("Duplicate the rule"));
    connect(copy, &QToolButton::clicked, this, &RulesDock::duplicateRule);
    row->addWidget(copy);
    auto* remove = button(box, "remove", tr("Delete the rule"));
    remove->setObjectName(QStringLiteral("removeRule"));
    connect(remove, &QToolButton::clicked, this, &RulesDock::removeRule);
    row->addWidget(remove);
    auto* test = button(box, "brush-event", tr("Try it on the selected people, or on all"));
    test->setObjectName(QStringLiteral("tryRule"));
    connect(test, &QToolButton::clicked, this, &RulesDock::tryRule);
    row->addWidget(test);
    row->addStretch(1);
    return box;
}

const Rule* RulesDock::current() const
{
    const auto& rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    return found == rules.end() ? nullptr : &*found;
}

void RulesDock::setRules(std::vector<Rule> rules, const QString& undoText)
{
    if (m_state.document().isEditOpen()) {
        return;
    }
    auto edit = m_state.document().beginEdit();
    edit->setRules(std::move(rules));
    edit->commit(undoText);
}

void RulesDock::change(const Change& apply)
{
    std::vector<Rule> rules = m_state.scene().rules;
    const auto found = std::ranges::find(rules, m_current, &Rule::id);
    if (m_isFilling || found == rules.end()) {
        return;
    }
    apply(*found);
    setRules(std::move(rules), tr("Change a rule"));
}

void RulesDock::addRule()
{
    std::vector<Rule> made(1);
    made.front().name = tr("New rule").toStdString();
    made.front().trigger.event = "cheer";
    made.front().actions.emplace_back();
    made.front().yields = model::RuleYield::Anybody;
    model::giveIds(made, m_state.scene());
    m_current = made.front().id;
    std::vector<Rule> rules = m_state.scene().rules;
    rules.push_back(made.front());
    setRules(std::move(rules), tr("Add a rule"));
}

void RulesDock::addSet(model::RuleSet set)
{
    std::vector<Rule> made = model::rulesOf(set, m_state.scene());
    model::giveIds(made, m_state.scene());
    m_current = made.front().id;
    // The event brush is ready for it.
    if (made.front().trigger.kind == TriggerKind::Event) {
        model::BrushSettings brush = m_state.brush(model::BrushKind::Event);
        brush.event.name = made.front().trigger.event;
        m_state.setBrush(brush);
    }
    std::vector<Rule> rules = m_state.scene().rules;
    rules.insert(rules.end(), made.begin(), made.end());
    setRules(std::move(rules), tr("Add rules: %1").arg(ruleSetName(set)));
}

void RulesDock::duplicateRule()
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

void RulesDock::removeRule()
{
    std::vector<Rule> rules = m_state.scene().rules;
    std::erase_if(rules, [this](const Rule& rule) { return rule.id == m_current; });
    setRules(std::move(rules), tr("Delete a rule"));
}

/// Lets what a rule waits for happen now.
void RulesDock::tryRule()
{
    const Rule* rule = current();
    if (rule == nullptr || rule->trigger.kind != TriggerKind::Event) {
        m_state.showStatus(tr("Choose a rule that begins with an event to try it."));
        return;
    }
    if (!m_state.session().isRunning()) {
        m_state.showStatus(tr("Press Play first: rules act while it plays."));
        return;
    }
    const auto all = m_state.scene().population.ids();
    const auto ids = m_state.selection().isEmpty() ? all : m_state.selection().ids();
    model::EventSettings event = m_state.brush(model::BrushKind::Event).event;
    event.name = rule->trigger.event;
    m_state.session().send(event, ids);
}

void RulesDock::takeOrder()
{
    std::vector<Rule> rules;
    for (int i = 0; i < m_list->count(); ++i) {
        const auto id = m_list->item(i)->data(kIdRole).toUInt();
        const auto& all = m_state.scene().rules;
        const auto found = std::ranges::find(all, id, &Rule::id);
        if (found != all.end()) {
            rules.push_back(*found);
        }
    }
    if (rules.size() == m_state.scene().rules.size()) {
        setRules(std::move(rules), tr("Reorder the rules"));
    }
}

void RulesDock::rebuildList()
{
    m_isFilling = true;
    m_list->clear();
    const model::Scene& scene = m_state.scene();
    for (const Rule& rule : scene.rules) {
        auto* item = new QListWidgetItem(ruleSentence(scene, rule), m_list);
        item->setData(kIdRole, rule.id);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(rule.isEnabled ? Qt::Checked : Qt::Unchecked);
        if (rule.id == m_current) {
            m_list->setCurrentItem(item);
        }
    }
    m_fit.start();
    m_note->setVisible(scene.rules.empty());
    m_list->setVisible(!scene.rules.empty()); // else the note would stand below an empty list
    m_isFilling = false;
    refreshCounts();
    showProblems();
}

/// What is wrong with a rule as it stands, or came to light while it runs.
QString RulesDock::problemOf(const Rule& rule) const
{
    const QString problem = ruleProblem(m_state.scene(), rule);
    if (!problem.isEmpty()) {
        return problem;
    }
    const std::vector<behavior::Problem>& problems = m_state.session().problems();
    const auto found = std::ranges::find(problems, rule.id, &behavior::Problem::rule);
    return found == problems.end() ? QString() : QString::fromStdString(found->text);
}

/// At the rules in the list, and below it for the one that is chosen.
void RulesDock::showProblems()
{
    m_isFilling = true;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const auto& rules = m_state.scene().rules;
        const auto rule = std::ranges::find(rules, item->data(kIdRole).toUInt(), &Rule::id);
        const QString problem = rule == rules.end() ? QString() : problemOf(*rule);
        item->setData(Qt::ForegroundRole,
                      problem.isEmpty() ? QVariant() : QVariant(QBrush(kProblemColor)));
        item->setToolTip(problem);
    }
    m_isFilling = false;
    const Rule* rule = current();
    const QString problem = rule == nullptr ? QString() : problemOf(*rule);
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void RulesDock::refreshCounts()
{
    const model::Scene& scene = m_state.scene();
    const bool isRunning = m_state.session().isRunning();
    m_isFilling = true;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const auto id = item->data(kIdRole).toUInt();
        const auto found = std::ranges::find(scene.rules, id, &Rule::id);
        if (found == scene.rules.end()) {
            continue;
        }
        const QString sentence = ruleSentence(scene, *found);
        const std::uint64_t count = isRunning ? m_state.session().firedCount(id) : 0;
        const QString text =
            count > 0
                ? tr("%1 (%2 ×)").arg(sentence, QLocale().toString(static_cast<qulonglong>(count)))
                : sentence;
        if (item->text() != text) {
            item->setText(text);
            m_fit.start();
        }
    }
    m_isFilling = false;
    const std::vector<behavior::RuleFired> fired = m_state.session().takeLog();
    for (const behavior::RuleFired& each : fired) {
        m_lines.push_back({each.seconds, each.rule, each.who});
        if (m_lines.size() > kMaxLines) {
            m_lines.pop_front();
        }
    }
    if (!fired.empty()) {
        showLog();
    }
}

void RulesDock::showLog()
{
    QStringList lines;
    for (const LogLine& line : m_lines) {
        if (m_onlySelected->isChecked() && !m_state.selection().contains(line.who)) {
            continue;
        }
        const auto& rules = m_state.scene().rules;
        const auto rule = std::ranges::find(rules, line.rule, &Rule::id);
        lines << tr("%1 s · person %2 · %3")
                     .arg(QLocale().toString(line.seconds, 'f', 2))
                     .arg(line.who)
                     .arg(rule == rules.end() ? tr("a rule") : QString::fromStdString(rule->name));
    }
    m_log->setPlainText(lines.join(QLatin1Char('\n')));
    m_log->moveCursor(QTextCursor::End);
}

/// Which of the editor's fields has the keyboard; -1: none.
qsizetype RulesDock::focusedField() const
{
    QWidget* field = QApplication::focusWidget();
    return m_editor != nullptr && field != nullptr
               ? m_editor->findChildren<QWidget*>().indexOf(field)
               : -1;
}

void RulesDock::rebuildEditor()
{
    const qsizetype focused = focusedField();
    delete m_editor;
    m_editor = nullptr;
    const Rule* rule = current();
    showProblems();
    if (rule == nullptr) {
        return;
    }
    const Rule shown = *rule;
    m_isFilling = true;
    m_editor = new RuleEditor(
        m_state.scene(), shown, [this](const auto& apply) { change(apply); }, m_editorArea);
    m_editorArea->layout()->addWidget(m_editor);
    const QList<QWidget*> fields = m_editor->findChildren<QWidget*>();
    if (focused >= 0 && focused < fields.size()) {
        fields[focused]->setFocus(Qt::TabFocusReason); // where the artist has gone on to
    }
    m_isFilling = false;
}

} // namespace crowd::widgets
