// SPDX-License-Identifier: MIT
#include "widgets/docks/RuleEditor.h"

#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/docks/RuleFields.h"
#include "widgets/docks/RuleTexts.h"
#include "widgets/docks/WrapRow.h"

namespace crowd::widgets {

using model::Condition;
using model::ConditionKind;
using model::Rule;
using model::Trigger;
using model::TriggerKind;

namespace {

constexpr int kIndent = 14; ///< logical pixels

/// Something that stands before the verb: "speed is above 1 m/s", not "is speed".
bool isComparison(const Condition& condition)
{
    switch (condition.kind) {
    case ConditionKind::Number:
    case ConditionKind::Speed:
    case ConditionKind::Payload:
    case ConditionKind::PeopleIn:
    case ConditionKind::Property:
        return true;
    default:
        return false;
    }
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

void RuleEditor::setTrigger(const std::function<void(Trigger&)>& change)
{
    m_apply([&](Rule& each) { change(each.trigger); });
}

void RuleEditor::setCondition(std::size_t index, const std::function<void(Condition&)>& change)
{
    m_apply([&](Rule& each) { change(each.conditions[index]); });
}

void RuleEditor::setAction(std::size_t index, const std::function<void(model::Action&)>& change)
{
    m_apply([&](Rule& each) { change(each.actions[index]); });
}

void RuleEditor::addMore(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    addTextButton(row, "addCondition", tr("+ only if…"), tr("Adds a condition"),
                  [](Rule& each) { each.conditions.emplace_back(); });
    addTextButton(row, "addAction", tr("+ then…"), tr("Adds something to do"),
                  [](Rule& each) { each.actions.emplace_back().kind = model::ActionKind::Wait; });
    row->addStretch(1);
}

void RuleEditor::addTrigger(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    row->addWidget(new QLabel(tr("When")));
    addChoiceField(row, triggerNames(), static_cast<int>(m_rule.trigger.kind), [this](int index) {
        setTrigger([&](Trigger& each) { each.kind = static_cast<TriggerKind>(index); });
    });
    if (m_rule.trigger.kind != TriggerKind::Start &&
        m_rule.trigger.kind != TriggerKind::ClipEnded) {
        addTriggerFields(indentedRowIn(layout));
    }
}

void RuleEditor::addTriggerFields(QHBoxLayout* row)
{
    const Trigger& trigger = m_rule.trigger;
    const auto addFloat = [&](float Trigger::*member, double low, double high,
                              const QString& suffix) {
        addNumberField(row, static_cast<double>(trigger.*member), low, high, suffix,
                       [this, member](double value) {
                           setTrigger(
                               [&](Trigger& each) { each.*member = static_cast<float>(value); });
                       });
    };
    switch (trigger.kind) {
    case TriggerKind::Event:
        addTextField(row, QString::fromStdString(trigger.event), tr("event"),
                     [this](const QString& text) {
                         setTrigger([&](Trigger& each) { each.event = text.toStdString(); });
                     });
        break;
    case TriggerKind::Arrived:
    case TriggerKind::Entered:
    case TriggerKind::Left:
        addPlaceField(row, m_scene, trigger.place, tr("any place"), [this](model::PlaceId place) {
            setTrigger([&](Trigger& each) { each.place = place; });
        });
        break;
    case TriggerKind::PathEnded:
    case TriggerKind::AheadFree:
        addPathField(row, m_scene, trigger.path, tr("any path"), [this](model::PathId path) {
            setTrigger([&](Trigger& each) { each.path = path; });
        });
        break;
    case TriggerKind::Every:
    case TriggerKind::Waited:
        addFloat(&Trigger::seconds, 0.1, 3600.0, tr(" s"));
        break;
    case TriggerKind::TagNear:
        addTagField(row, m_scene, trigger.tag, [this](std::uint8_t tag) {
            setTrigger([&](Trigger& each) { each.tag = tag; });
        });
        row->addWidget(new QLabel(tr("within")));
        addFloat(&Trigger::metres, 0.1, 100.0, tr(" m"));
        break;
    case TriggerKind::SpeedLimit:
        addChoiceField(
            row, {tr("slower than"), tr("faster than")}, trigger.isAbove ? 1 : 0,
            [this](int index) { setTrigger([&](Trigger& each) { each.isAbove = index == 1; }); });
        addFloat(&Trigger::metresPerSecond, 0.0, 20.0, tr(" m/s"));
        break;
    case TriggerKind::Start:
    case TriggerKind::ClipEnded:
        break;
    }
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
    const bool isCompared = isComparison(condition);
    if (!isCompared) {
        addNegation(row, index);
    }
    addChoiceField(
        row, conditionNames(), static_cast<int>(condition.kind), [this, index](int kind) {
            setCondition(index,
                         [&](Condition& each) { each.kind = static_cast<ConditionKind>(kind); });
        });
    if (isCompared) {
        addSubject(row, index);
    }
    addRemoveButton(row, tr("Remove this condition"), [this, index] {
        m_apply([&](Rule& each) {
            each.conditions.erase(each.conditions.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    if (condition.kind != ConditionKind::IsSeated) {
        addConditionFields(indentedRowIn(layout), index);
    }
}

/// "is", "is not", or what suits better.
void RuleEditor::addNegation(QHBoxLayout* row, std::size_t index)
{
    const Condition& condition = m_rule.conditions[index];
    addChoiceField(row, verbsOf(condition.kind), condition.isNot ? 1 : 0,
                   [this, index](int choice) {
                       setCondition(index, [&](Condition& each) { each.isNot = choice == 1; });
                   });
}

void RuleEditor::addConditionPlace(QHBoxLayout* row, std::size_t index)
{
    addPlaceField(row, m_scene, m_rule.conditions[index].place, {},
                  [this, index](model::PlaceId place) {
                      setCondition(index, [&](Condition& each) { each.place = place; });
                  });
}

/// What exactly is compared.
void RuleEditor::addSubject(QHBoxLayout* row, std::size_t index)
{
    const Condition& condition = m_rule.conditions[index];
    if (condition.kind == ConditionKind::Number) {
        addArtistNumberField(row, m_scene, condition.number, [this, index](model::NumberId number) {
            setCondition(index, [&](Condition& each) { each.number = number; });
        });
    } else if (condition.kind == ConditionKind::PeopleIn) {
        addConditionPlace(row, index);
    } else if (condition.kind == ConditionKind::Property) {
        addChoiceField(row, comparedNames(), static_cast<int>(condition.property),
                       [this, index](int property) {
                           setCondition(index, [&](Condition& each) {
                               each.property = static_cast<model::ComparedProperty>(property);
                           });
                       });
    }
}

void RuleEditor::addTemplate(QHBoxLayout* row, std::size_t index)
{
    QStringList names;
    int chosen = -1;
    for (const model::TemplateEntry& entry : m_scene.templates) {
        chosen = entry.id == m_rule.conditions[index].templateId ? static_cast<int>(names.size())
                                                                 : chosen;
        names << QString::fromStdString(entry.name);
    }
    addChoiceField(row, names, chosen, [this, index](int choice) {
        const model::TemplateId id = m_scene.templates[static_cast<std::size_t>(choice)].id;
        setCondition(index, [&](Condition& each) { each.templateId = id; });
    });
}

/// "is below 3", "is at 3", "is above 3".
void RuleEditor::addComparison(QHBoxLayout* row, std::size_t index, const QString& suffix)
{
    const Condition& condition = m_rule.conditions[index];
    addNegation(row, index);
    addChoiceField(row, comparisonNames(), static_cast<int>(condition.comparison),
                   [this, index](int choice) {
                       setCondition(index, [&](Condition& each) {
                           each.comparison = static_cast<model::Comparison>(choice);
                       });
                   });
    addNumberField(
        row, static_cast<double>(condition.value), -1e6, 1e6, suffix, [this, index](double value) {
            setCondition(index, [&](Condition& each) { each.value = static_cast<float>(value); });
        });
}

void RuleEditor::addConditionFields(QHBoxLayout* row, std::size_t index)
{
    const Condition& condition = m_rule.conditions[index];
    switch (condition.kind) {
    case ConditionKind::HasTag:
        addTagField(row, m_scene, condition.tag, [this, index](std::uint8_t tag) {
            setCondition(index, [&](Condition& each) { each.tag = tag; });
        });
        break;
    case ConditionKind::OfTemplate:
        addTemplate(row, index);
        break;
    case ConditionKind::InPlace:
    case ConditionKind::IsFull:
        addConditionPlace(row, index);
        break;
    case ConditionKind::FollowsPath:
        addPathField(row, m_scene, condition.path, tr("any path"),
                     [this, index](model::PathId path) {
                         setCondition(index, [&](Condition& each) { each.path = path; });
                     });
        break;
    case ConditionKind::Chance:
        row->addWidget(new QLabel(tr("in")));
        addNumberField(row, static_cast<double>(condition.chance) * 100.0, 0.0, 100.0,
                       tr(" % of cases"), [this, index](double value) {
                           setCondition(index, [&](Condition& each) {
                               each.chance = static_cast<float>(value / 100.0);
                           });
                       });
        break;
    case ConditionKind::Speed:
        addComparison(row, index, tr(" m/s"));
        break;
    case ConditionKind::Number:
    case ConditionKind::Payload:
    case ConditionKind::PeopleIn:
        addComparison(row, index, {});
        break;
    case ConditionKind::Property:
        if (condition.property == model::ComparedProperty::Clip) {
            addNegation(row, index);
            addOneClipField(row, m_scene, condition.clip, [this, index](const std::string& clip) {
                setCondition(index, [&](Condition& each) { each.clip = clip; });
            });
        } else {
            const bool isPace = condition.property == model::ComparedProperty::WalkSpeed;
            addComparison(row, index, isPace ? tr(" m/s") : tr(" ×"));
        }
        break;
    case ConditionKind::IsSeated:
        break;
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
