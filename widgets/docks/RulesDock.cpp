// SPDX-License-Identifier: MIT
#include "widgets/docks/RulesDock.h"

#include <algorithm>
#include <utility>

#include <QtCore/QLocale>
#include <QtCore/QScopeGuard>
#include <QtCore/QTimer>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/rules/CueBar.h"
#include "widgets/rules/NamesForm.h"
#include "widgets/rules/RuleEditor.h"
#include "widgets/rules/RuleItemDelegate.h"
#include "widgets/rules/RuleProblems.h"
#include "widgets/rules/RuleTexts.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

using model::Rule;

namespace {

constexpr int kCountMs = 250;
constexpr int kWideFrom = 640; ///< logical pixels: for three columns
constexpr int kColumnGap = 12;
constexpr int kLeastListHeight = 34; ///< logical pixels
constexpr int kMostListHeight = 240;
constexpr QColor kProblemColor(208, 80, 64);

} // namespace

RulesDock::RulesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Rules"), "rules", parent), m_state(state), m_list(new QListWidget(this)),
      m_commands(new RuleCommands(state, *m_list, this))
{
    buildContent();
    connectTimers();
    connectState();
    connectList();
    rebuildList();
    rebuildEditor();
    if (m_state.session().isRunning()) {
        m_counting.start();
    }
}

/// The chosen rule comes first: the fields to compare are its own.
void RulesDock::takeOver(DockBase& before)
{
    const auto& old = static_cast<const RulesDock&>(before);
    m_commands->setCurrentId(old.m_commands->currentId());
    m_fired = old.m_fired;
    m_seen = old.m_seen;
    rebuildList();
    rebuildEditor();
    DockBase::takeOver(before);
    showLog();
}

void RulesDock::buildContent()
{
    auto* content = new QWidget(this);
    m_columns = new QBoxLayout(QBoxLayout::TopToBottom, content);
    m_columns->setContentsMargins(4, 4, 4, 4);
    m_columns->setSpacing(kColumnGap);
    addColumn([this, content](QVBoxLayout& rules) {
        rules.addWidget(m_commands->makeButtons(content));
        m_cues = new CueBar(m_state, content);
        rules.addWidget(m_cues);
        setUpList();
        rules.addWidget(m_list);
        addNotes(rules);
        rules.addStretch(1);
    });
    addColumn([this, content](QVBoxLayout& chosen) {
        m_editorArea = new QWidget(content);
        auto* area = new QVBoxLayout(m_editorArea);
        area->setContentsMargins(0, 0, 0, 0);
        area->addStretch(1);
        m_editorScroll = new QScrollArea(content);
        m_editorScroll->setFrameShape(QFrame::NoFrame);
        m_editorScroll->setWidgetResizable(true);
        m_editorScroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        m_editorScroll->hide();
        chosen.addWidget(m_editorScroll, 1);
        chosen.addWidget(m_editorArea);
    });
    addColumn([this, content](QVBoxLayout& fired) { addLog(fired, content); });
    setScrolledContent(content);
}

/// One below the other where the panel is narrow, side by side where there is room.
void RulesDock::addColumn(const std::function<void(QVBoxLayout&)>& fill)
{
    auto* column = new QVBoxLayout();
    fill(*column);
    m_columns->addLayout(column, 1);
}

void RulesDock::addLog(QVBoxLayout& layout, QWidget* content)
{
    m_onlySelected = new QCheckBox(tr("Log only the selected characters"), content);
    layout.addWidget(m_onlySelected);
    m_log = new QPlainTextEdit(content);
    m_log->setObjectName(QStringLiteral("ruleLog"));
    m_log->setReadOnly(true);
    m_log->setPlaceholderText(tr("What fired, while it plays"));
    m_log->setMinimumHeight(50);
    layout.addWidget(m_log, 1);
    layout.addWidget(new NamesForm(m_state, content));
}

/// Beside other columns, so that list, cues and log stay in sight.
void RulesDock::scrollEditorAlone(bool isAlone)
{
    if (isAlone == (m_editorScroll->widget() != nullptr)) {
        return;
    }
    if (isAlone) {
        m_editorScroll->setWidget(m_editorArea);
    } else {
        auto* column = static_cast<QVBoxLayout*>(m_columns->itemAt(1)->layout());
        column->insertWidget(1, m_editorScroll->takeWidget());
    }
    m_editorArea->show();
    m_editorScroll->setVisible(isAlone);
}

void RulesDock::arrangeColumns()
{
    const bool isWide = width() >= kWideFrom;
    scrollEditorAlone(isWide);
    // Cues that take several lines leave a low panel's list no room.
    auto* first = static_cast<QVBoxLayout*>(m_columns->itemAt(0)->layout());
    auto* last = static_cast<QVBoxLayout*>(m_columns->itemAt(m_columns->count() - 1)->layout());
    (isWide ? last : first)->insertWidget(isWide ? 0 : 1, m_cues);
    m_columns->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    for (int i = 0; i < m_columns->count(); ++i) {
        // In a single one the log takes what is left.
        const bool isLog = i == m_columns->count() - 1;
        const int wide = isLog ? 3 : 4; // sentences and fields want the most
        m_columns->setStretch(i, isWide ? wide : isLog ? 1 : 0);
    }
}

void RulesDock::setUpList()
{
    m_list->setObjectName(QStringLiteral("ruleList"));
    m_list->setWordWrap(true);
    m_list->setItemDelegate(new RuleItemDelegate(m_list));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QWidget::customContextMenuRequested, this, &RulesDock::showMenu);
}

/// What there is to say where there is no rule, or something is wrong with one.
void RulesDock::addNotes(QVBoxLayout& layout)
{
    m_note = new QLabel(tr("No rules yet. “Add” has ready-made ones to begin with; the event "
                           "brush (E) sets them off while it plays."),
                        this);
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    layout.addWidget(m_note);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("ruleProblem"));
    m_problem->setWordWrap(true);
    m_problem->setStyleSheet(QStringLiteral("color: %1").arg(kProblemColor.name()));
    layout.addWidget(m_problem);
}

void RulesDock::connectTimers()
{
    m_fit.setSingleShot(true);
    m_fit.setInterval(0);
    connect(&m_fit, &QTimer::timeout, this, &RulesDock::fitList);
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, [this] {
        rebuildList();
        rebuildEditor();
        showLog(); // by the names of now
    });
    m_counting.setInterval(kCountMs);
    connect(&m_counting, &QTimer::timeout, this, &RulesDock::refreshCounts);
}

void RulesDock::connectState()
{
    connect(
        &m_state.document(), &model::SceneDocument::changed, this,
        [this](const model::SceneChange& change) {
            if (isOneOf<model::SceneReplaced>(change)) {
                forgetLog(); // it is of another scene
            }
            if (isOneOf<model::RulesChanged, model::PathsChanged, model::StatesChanged,
                        model::LightsChanged, model::FeaturesChanged, model::RelationKindsChanged,
                        model::TemplatesChanged, model::SceneReplaced>(change)) {
                m_rebuild.start();
            }
        });
    connect(&m_state.session(), &SessionControl::stateChanged, this, [this] {
        if (m_state.session().isRunning()) {
            forgetLog();
            m_counting.start();
        } else {
            m_counting.stop();
        }
        refreshCounts();
    });
    connect(&m_state.session(), &SessionControl::problemsChanged, this, &RulesDock::showProblems);
    connect(m_onlySelected, &QCheckBox::clicked, this, &RulesDock::showLog);
    connect(&m_state.selection(), &Selection::changed, this, &RulesDock::showLog);
}

void RulesDock::connectList()
{
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (!m_isFilling) {
            m_commands->setCurrentId(item == nullptr ? 0 : item->data(kIdRole).toUInt());
            if (item != nullptr) {
                item->setSelected(true); // the focus alone makes the first one current
            }
            rebuildEditor();
        }
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_isFilling) {
            m_commands->setCurrentId(item->data(kIdRole).toUInt());
            const bool isOn = item->checkState() == Qt::Checked;
            m_commands->change([isOn](Rule& rule) { rule.isEnabled = isOn; });
        }
    });
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &RulesDock::takeOrder);
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
    arrangeColumns();
    m_fit.start(); // sentences break elsewhere
}

void RulesDock::takeOrder()
{
    std::vector<model::RuleId> order;
    order.reserve(static_cast<std::size_t>(m_list->count()));
    for (int i = 0; i < m_list->count(); ++i) {
        order.push_back(m_list->item(i)->data(kIdRole).toUInt());
    }
    m_commands->reorder(order);
}

void RulesDock::showMenu(const QPoint& position)
{
    QListWidgetItem* item = m_list->itemAt(position);
    if (item == nullptr || m_state.document().isEditOpen()) {
        return;
    }
    m_list->setCurrentItem(item);
    QMenu menu(this);
    m_commands->fill(menu);
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

/// Rows that are there already stay, so that nothing jumps under the hands of who edits one.
void RulesDock::rebuildList()
{
    m_isFilling = true;
    const model::Scene& scene = m_state.scene();
    const int count = static_cast<int>(scene.rules.size());
    while (m_list->count() > count) {
        delete m_list->takeItem(m_list->count() - 1);
    }
    for (int row = 0; row < count; ++row) {
        const Rule& rule = scene.rules[static_cast<std::size_t>(row)];
        QListWidgetItem* item =
            row < m_list->count() ? m_list->item(row) : new QListWidgetItem(m_list);
        item->setText(ruleSentence(scene, rule));
        item->setData(kIdRole, rule.id);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(rule.isEnabled ? Qt::Checked : Qt::Unchecked);
        if (rule.id == m_commands->currentId() && m_list->currentRow() != row) {
            m_list->setCurrentItem(item);
        }
    }
    if (m_commands->current() == nullptr) {
        m_list->setCurrentItem(nullptr);
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
    QString problem = ruleProblem(m_state.scene(), rule);
    if (!problem.isEmpty()) {
        return problem;
    }
    const std::vector<behavior::Problem>& problems = m_state.session().problems();
    const auto found = std::ranges::find(problems, rule.id, &behavior::Problem::rule);
    return found == problems.end() ? QString() : model::translated(found->text);
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
    const Rule* rule = m_commands->current();
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
        const std::uint64_t count = isRunning ? m_state.session().firedCount(id) : 0;
        const QString text =
            count > 0 ? tr("%1 ×").arg(QLocale().toString(static_cast<qulonglong>(count)))
                      : QString();
        if (item->data(kRuleCountRole).isValid() != isRunning) {
            m_fit.start(); // once: from here on counting moves nothing
        }
        item->setData(kRuleCountRole, isRunning ? QVariant(text) : QVariant());
    }
    m_isFilling = false;
    const FiringHistory& firings = m_state.session().firings();
    if (m_seen < firings.begin()) { // the run goes on from an earlier time, or there were too many
        m_seen = firings.begin();
        m_fired.clear();
        showLog();
    }
    const auto fired = firings.since(m_seen);
    for (const behavior::RuleFired& each : fired) {
        m_fired.add(each);
    }
    m_seen = firings.end();
    if (!fired.empty()) {
        showLog();
    }
}

void RulesDock::forgetLog()
{
    m_seen = m_state.session().firings().end();
    m_fired.clear();
    showLog();
}

/// Goes on to the end, unless the artist reads further up.
void RulesDock::showLog()
{
    const bool isForAll = !m_onlySelected->isChecked();
    const QStringList lines =
        m_fired.lines(m_state.scene(), [this, isForAll](model::IndividualId who) {
            return isForAll || m_state.selection().contains(who);
        });
    QScrollBar& bar = *m_log->verticalScrollBar();
    const int place = bar.value();
    const bool isAtEnd = place == bar.maximum();
    m_log->setPlainText(lines.join(QLatin1Char('\n')));
    bar.setValue(isAtEnd ? bar.maximum() : place);
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
    // What is below the editor stays where it is while there is none for a moment.
    m_editorArea->setMinimumHeight(m_editor != nullptr ? m_editor->height() : 0);
    const auto letGo = qScopeGuard([this] {
        QMetaObject::invokeMethod(
            this, [this] { m_editorArea->setMinimumHeight(0); }, Qt::QueuedConnection);
    });
    delete m_editor;
    m_editor = nullptr;
    const Rule* rule = m_commands->current();
    showProblems();
    m_commands->enable();
    if (rule == nullptr) {
        return;
    }
    const Rule shown = *rule;
    m_isFilling = true;
    const auto change = [this](const RuleCommands::Change& apply) {
        if (!m_isFilling) {
            m_commands->change(apply);
        }
    };
    m_editor = new RuleEditor(m_state.scene(), shown, change, m_editorArea);
    static_cast<QVBoxLayout*>(m_editorArea->layout())->insertWidget(0, m_editor);
    const QList<QWidget*> fields = m_editor->findChildren<QWidget*>();
    if (focused >= 0 && focused < fields.size()) {
        fields[focused]->setFocus(Qt::TabFocusReason); // where the artist has gone on to
    }
    m_isFilling = false;
    showAdded(shown);
}

/// What was just added stands further up than the button that adds it.
void RulesDock::showAdded(const Rule& rule)
{
    const Rule before = std::exchange(m_edited, rule);
    QWidget* added = nullptr;
    if (before.id == rule.id && rule.conditions.size() > before.conditions.size()) {
        added = m_editor->lastCondition();
    } else if (before.id == rule.id && rule.actions.size() > before.actions.size()) {
        added = m_editor->lastAction();
    }
    if (added == nullptr) {
        return;
    }
    // Once all have their places.
    QTimer::singleShot(0, added, [this, added] {
        for (QWidget* each = added->parentWidget(); each != nullptr && each != this;
             each = each->parentWidget()) {
            if (auto* area = qobject_cast<QScrollArea*>(each)) {
                area->ensureWidgetVisible(added);
            }
        }
        added->setFocus(Qt::OtherFocusReason);
    });
}

} // namespace crowd::widgets
