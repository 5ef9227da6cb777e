// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleEditor.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/rules/RuleSequence.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/rules/RuleFields.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/rules/RuleOrder.h"

namespace crowd::widgets {

using model::Action;
using model::Condition;
using model::Rule;
using model::Trigger;

namespace {

constexpr int kIndent = 14; ///< logical pixels

/// Something that stands before the verb: "speed is above 1 m/s", not "is speed".
bool isComparison(const model::RuleKind& kind)
{
    return std::ranges::any_of(kind.fields, [](const model::FieldInfo& field) {
        return std::string_view(field.meta.key) == "compare";
    });
}

/// Index of a kind in the order of a menu, with lines between groups.
std::vector<std::vector<int>> groupsOf(std::span<const model::RuleKind> kinds)
{
    std::vector<std::vector<int>> groups(1);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i].text.beginsGroup) {
            groups.emplace_back();
        }
        groups.back().push_back(static_cast<int>(i));
    }
    return groups;
}

} // namespace

RuleEditor::RuleEditor(const model::Scene& scene, const Rule& rule,
                       std::function<void(const Change&)> apply, QWidget* parent)
    : QWidget(parent), m_scene(scene), m_rule(rule), m_apply(std::move(apply))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    addTextField(rowIn(layout), QString::fromStdString(m_rule.name), tr("Name"),
                 [this](const QString& text) {
                     m_apply([&](Rule& each) { each.name = text.toStdString(); });
                 });
    addTrigger(layout);
    for (std::size_t i = 0; i < m_rule.conditions.size(); ++i) {
        addCondition(layout, i);
    }
    for (std::size_t i = 0; i < m_rule.actions.size(); ++i) {
        addAction(layout, i);
    }
    addMore(layout);
    addMeeting(layout);
}

QHBoxLayout* RuleEditor::rowIn(QVBoxLayout* layout) const
{
    auto* row = new WrapRow;
    row->setSpacing(4);
    if (m_depth > 0) {
        row->addSpacing(kIndent * m_depth);
    }
    layout->addLayout(row);
    return row;
}

QHBoxLayout* RuleEditor::indentedRowIn(QVBoxLayout* layout) const
{
    QHBoxLayout* row = rowIn(layout);
    row->addSpacing(kIndent);
    return row;
}

QHBoxLayout* RuleEditor::labelledRowIn(QVBoxLayout* layout, const QString& label,
                                       const QString& tip) const
{
    QHBoxLayout* row = indentedRowIn(layout);
    auto* shown = new QLabel(label);
    shown->setToolTip(tip);
    row->addWidget(shown);
    return row;
}

void RuleEditor::addTextButton(QHBoxLayout* row, const char* name, const QString& text,
                               const QString& tip, const Change& change)
{
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setAutoRaise(true);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, change] { m_apply(change); });
}

template<class Part>
PartRows RuleEditor::rowsFor(QVBoxLayout* layout, std::function<Part&(Rule&)> partOf)
{
    Rule shown = m_rule;
    const std::size_t kind = partOf(shown).data.index();
    const auto change = [this, partOf, kind](const model::FieldInfo& field,
                                             const model::FieldValue& value) {
        m_apply([&](Rule& each) {
            Part& part = partOf(each);
            if (part.data.index() == kind) { // else this editor is about to go
                field.set(part.object(), value);
            }
        });
    };
    return {m_scene, layout, [this, layout] { return indentedRowIn(layout); }, change};
}

void RuleEditor::addMore(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    addKindButton(row, "addCondition", tr("+ only if…"), tr("Adds a condition"),
                  model::kindsOf<model::ConditionData>(), [](Rule& each, std::size_t kind) {
                      each.conditions.emplace_back().change(kind);
                  });
    addKindButton(row, "addAction", tr("+ then…"), tr("Adds something to do"),
                  model::kindsOf<model::ActionData>(), [](Rule& each, std::size_t kind) {
                      each.actions.emplace_back(model::actions::Wait()).change(kind);
                  });
    row->addStretch(1);
}

/// What is to be added is chosen first: nothing stands there that nobody wanted.
void RuleEditor::addKindButton(QHBoxLayout* row, const char* name, const QString& text,
                               const QString& tip, std::span<const model::RuleKind> kinds,
                               void (*add)(Rule&, std::size_t kind))
{
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setText(text + QStringLiteral("  ")); // beside its arrow
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    const QStringList names = kindNamesAlone(kinds);
    for (const std::vector<int>& group : groupsOf(kinds)) {
        if (!menu->isEmpty()) {
            menu->addSeparator();
        }
        for (const int kind : group) {
            menu->addAction(names[kind], this, [this, add, kind] {
                m_apply([&](Rule& each) { add(each, static_cast<std::size_t>(kind)); });
            });
        }
    }
    button->setMenu(menu);
    row->addWidget(button);
}

void RuleEditor::addTrigger(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    row->addWidget(new QLabel(tr("When")));
    const Trigger& trigger = m_rule.trigger;
    addChoiceField(
        row, kindNames(model::kindsOf<model::TriggerData>()),
        static_cast<int>(trigger.data.index()), [this](int kind) {
            m_apply([kind](Rule& each) { each.trigger.change(static_cast<std::size_t>(kind)); });
        });
    rowsFor<Trigger>(layout, [](Rule& each) -> Trigger& {
        return each.trigger;
    }).add(trigger.kind().fields, trigger.object());
}

void RuleEditor::addCondition(QVBoxLayout* layout, std::size_t index)
{
    QHBoxLayout* row = rowIn(layout);
    const Condition& condition = m_rule.conditions[index];
    if (index == 0) {
        row->addWidget(new QLabel(tr("if")));
    } else {
        addChoiceField(row, {tr("and"), tr("or")}, m_rule.isAnyEnough ? 1 : 0, [this](int choice) {
            m_apply([&](Rule& each) { each.isAnyEnough = choice == 1; });
        });
    }
    const bool isCompared = isComparison(condition.kind());
    if (!isCompared) {
        addNegation(row, index);
    }
    addChoiceField(row, kindNames(model::kindsOf<model::ConditionData>()),
                   static_cast<int>(condition.data.index()), [this, index](int kind) {
                       m_apply([&](Rule& each) {
                           each.conditions[index].change(static_cast<std::size_t>(kind));
                       });
                   });
    m_lastCondition = row->itemAt(row->count() - 1)->widget();
    PartRows rows = rowsFor<Condition>(
        layout, [index](Rule& each) -> Condition& { return each.conditions[index]; });
    std::span<const model::FieldInfo> fields = condition.kind().fields;
    if (isCompared && std::string_view(fields.front().meta.key) != "compare") {
        rows.addField(row, fields.front(), condition.object()); // what exactly is compared
        fields = fields.subspan(1);
    }
    addRemoveButton(row, tr("Remove this condition"), [this, index] {
        m_apply([&](Rule& each) {
            each.conditions.erase(each.conditions.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    if (isCompared) { // "is below 3", "is at 3", "is above 3"
        QHBoxLayout* verb = indentedRowIn(layout);
        addNegation(verb, index);
        rows.newRow = [verb] { return verb; };
    }
    rows.add(fields, condition.object());
}

/// "is", "is not", or what suits better.
void RuleEditor::addNegation(QHBoxLayout* row, std::size_t index)
{
    const Condition& condition = m_rule.conditions[index];
    const model::KindText& text = condition.kind().text;
    addChoiceField(row, {ruleText(text.yes), ruleText(text.no)}, condition.isNot ? 1 : 0,
                   [this, index](int choice) {
                       m_apply([&](Rule& each) { each.conditions[index].isNot = choice == 1; });
                   });
}

void RuleEditor::addAction(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    m_depth = action.depth;
    QHBoxLayout* row = rowIn(layout);
    row->addWidget(new QLabel(wordBefore(m_rule.actions, index)));
    const std::span<const model::RuleKind> kinds = model::kindsOf<model::ActionData>();
    addGroupedField(row, kindNames(kinds), groupsOf(kinds), static_cast<int>(action.data.index()),
                    [this, index](int kind) {
                        m_apply([&](Rule& each) {
                            each.actions[index].change(static_cast<std::size_t>(kind));
                            model::settleDepths(each.actions); // nothing may belong to it now
                        });
                    });
    m_lastAction = row->itemAt(row->count() - 1)->widget();
    if (m_rule.actions.size() > 1) {
        addMoveButtons(*row, *this, m_rule.actions, index, m_apply);
    }
    addRemoveButton(
        row, model::isHead(action) ? tr("Remove this and what is in it") : tr("Remove this"),
        [this, index] { m_apply([&](Rule& each) { model::removeLine(each.actions, index); }); });
    const PartRows rows =
        rowsFor<Action>(layout, [index](Rule& each) -> Action& { return each.actions[index]; });
    QHBoxLayout* last = rows.add(action.kind().fields, action.object());
    if (model::isHead(action)) {
        addBlockButtons(last == nullptr ? indentedRowIn(layout) : last, index);
    }
    m_depth = 0;
}

/// More of what repeats, or is one of several.
void RuleEditor::addBlockButtons(QHBoxLayout* row, std::size_t index)
{
    addTextButton(
        row, "addInside", tr("+ in it"), tr("Adds something to do in it"),
        [index](Rule& each) { model::addInside(each.actions, index, model::actions::Wait()); });
    if (m_rule.actions[index].is<model::actions::OneOf>()) {
        addTextButton(row, "addAlternative", tr("+ or…"), tr("Adds another one to choose among"),
                      [index](Rule& each) { model::addAlternative(each.actions, index); });
    }
}

void RuleEditor::addMeeting(QVBoxLayout* layout)
{
    addChoiceField(
        rowIn(layout), meetingNames(), static_cast<int>(m_rule.meeting), [this](int index) {
            m_apply([&](Rule& each) { each.meeting = static_cast<model::RuleMeeting>(index); });
        });
    addChoiceField(rowIn(layout), yieldNames(), static_cast<int>(m_rule.yields), [this](int index) {
        m_apply([&](Rule& each) { each.yields = static_cast<model::RuleYield>(index); });
    });
    QHBoxLayout* row =
        labelledRowIn(layout, tr("pause"), tr("Before it comes again for the same character"));
    addNumberField(row, static_cast<double>(m_rule.cooldownSeconds), 0.0, 3600.0, tr(" s"),
                   [this](double value) {
                       m_apply(
                           [&](Rule& each) { each.cooldownSeconds = static_cast<float>(value); });
                   });
    row = labelledRowIn(layout, tr("at most"), tr("So often for the same character"));
    addCountField(
        row, m_rule.limit, 1000, tr(" ×"),
        [this](std::uint32_t limit) { m_apply([&](Rule& each) { each.limit = limit; }); },
        tr("as often as it comes"));
}

} // namespace crowd::widgets
