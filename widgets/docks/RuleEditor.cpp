// SPDX-License-Identifier: MIT
#include "widgets/docks/RuleEditor.h"

#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/docks/RuleFields.h"
#include "widgets/docks/RuleTexts.h"

namespace crowd::widgets {

using model::Action;
using model::ActionKind;
using model::Condition;
using model::ConditionKind;
using model::Rule;
using model::Trigger;
using model::TriggerKind;

namespace {

QHBoxLayout* rowIn(QVBoxLayout* layout)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    layout->addLayout(row);
    return row;
}

/// What belongs to the row above, a little further in.
QHBoxLayout* indentedRowIn(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    row->addSpacing(20);
    return row;
}

/// With values that suit it.
void setKind(Action& action, ActionKind kind)
{
    action.kind = kind;
    if (kind == ActionKind::SitDown) {
        action.metres = 0.0F;
    } else if (kind == ActionKind::WaitForEvent) {
        action.seconds = 0.0F;
    } else if (kind == ActionKind::Follow || kind == ActionKind::GoToPerson) {
        action.metres = 1.5F;
        action.seconds = kind == ActionKind::Follow ? 10.0F : 0.0F;
    }
    const bool isToPerson = kind == ActionKind::Follow || kind == ActionKind::GoToPerson;
    if (isToPerson && action.aim == model::ActionAim::Place) {
        action.aim = model::ActionAim::Sender;
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

void RuleEditor::setTrigger(const std::function<void(Trigger&)>& change)
{
    m_apply([&](Rule& each) { change(each.trigger); });
}

void RuleEditor::setCondition(std::size_t index, const std::function<void(Condition&)>& change)
{
    m_apply([&](Rule& each) { change(each.conditions[index]); });
}

void RuleEditor::setAction(std::size_t index, const std::function<void(Action&)>& change)
{
    m_apply([&](Rule& each) { change(each.actions[index]); });
}

void RuleEditor::addMore(QVBoxLayout* layout)
{
    QHBoxLayout* row = rowIn(layout);
    const auto addButton = [&](const char* name, const QString& text, const Change& change) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setAutoRaise(true);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, change] { m_apply(change); });
    };
    addButton("addCondition", tr("+ only if…"), [](Rule& each) { each.conditions.emplace_back(); });
    addButton("addAction", tr("+ then…"),
              [](Rule& each) { each.actions.emplace_back().kind = ActionKind::Wait; });
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
    addChoiceField(row, {tr("is"), tr("is not")}, condition.isNot ? 1 : 0,
                   [this, index](int choice) {
                       setCondition(index, [&](Condition& each) { each.isNot = choice == 1; });
                   });
    addChoiceField(
        row, conditionNames(), static_cast<int>(condition.kind), [this, index](int kind) {
            setCondition(index,
                         [&](Condition& each) { each.kind = static_cast<ConditionKind>(kind); });
        });
    addRemoveButton(row, tr("Remove this condition"), [this, index] {
        m_apply([&](Rule& each) {
            each.conditions.erase(each.conditions.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    if (condition.kind != ConditionKind::IsSeated) {
        addConditionFields(indentedRowIn(layout), index);
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

/// "less than 3", "3", "more than 3".
void RuleEditor::addComparison(QHBoxLayout* row, std::size_t index, const QString& suffix)
{
    const Condition& condition = m_rule.conditions[index];
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
    const auto addPlace = [&] {
        addPlaceField(row, m_scene, condition.place, {}, [this, index](model::PlaceId place) {
            setCondition(index, [&](Condition& each) { each.place = place; });
        });
    };
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
        addPlace();
        break;
    case ConditionKind::FollowsPath:
        addPathField(row, m_scene, condition.path, tr("any path"),
                     [this, index](model::PathId path) {
                         setCondition(index, [&](Condition& each) { each.path = path; });
                     });
        break;
    case ConditionKind::Chance:
        addNumberField(row, static_cast<double>(condition.chance) * 100.0, 0.0, 100.0, tr(" %"),
                       [this, index](double value) {
                           setCondition(index, [&](Condition& each) {
                               each.chance = static_cast<float>(value / 100.0);
                           });
                       });
        break;
    case ConditionKind::Number:
        addArtistNumberField(row, m_scene, condition.number, [this, index](model::NumberId number) {
            setCondition(index, [&](Condition& each) { each.number = number; });
        });
        addComparison(row, index, {});
        break;
    case ConditionKind::Speed:
        addComparison(row, index, tr(" m/s"));
        break;
    case ConditionKind::Payload:
        addComparison(row, index, {});
        break;
    case ConditionKind::PeopleIn:
        addPlace();
        addComparison(row, index, {});
        break;
    case ConditionKind::IsSeated:
        break;
    }
}

void RuleEditor::addAction(QVBoxLayout* layout, std::size_t index)
{
    QHBoxLayout* row = rowIn(layout);
    row->addWidget(new QLabel(index == 0 ? tr("do") : tr("then")));
    addChoiceField(
        row, actionNames(), static_cast<int>(m_rule.actions[index].kind), [this, index](int kind) {
            setAction(index, [&](Action& each) { setKind(each, static_cast<ActionKind>(kind)); });
        });
    const auto addMove = [&](Qt::ArrowType arrow, const QString& tip, std::size_t other) {
        auto* button = new QToolButton(this);
        button->setArrowType(arrow);
        button->setAutoRaise(true);
        button->setToolTip(tip);
        button->setEnabled(other < m_rule.actions.size());
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, index, other] {
            m_apply([&](Rule& each) { std::swap(each.actions[index], each.actions[other]); });
        });
    };
    if (m_rule.actions.size() > 1) {
        addMove(Qt::UpArrow, tr("Earlier"), index - 1); // the first has none before it
        addMove(Qt::DownArrow, tr("Later"), index + 1);
    }
    addRemoveButton(row, tr("Remove this"), [this, index] {
        m_apply([&](Rule& each) {
            each.actions.erase(each.actions.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    addActionFields(layout, index);
}

void RuleEditor::addNumber(QHBoxLayout* row, std::size_t index, float Action::*member, double low,
                           double high, const QString& suffix, const QString& zero)
{
    addNumberField(
        row, static_cast<double>(m_rule.actions[index].*member), low, high, suffix,
        [this, index, member](double edited) {
            setAction(index, [&](Action& each) { each.*member = static_cast<float>(edited); });
        },
        zero);
}

void RuleEditor::addGoFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    addChoiceField(indentedRowIn(layout), choiceNames(), static_cast<int>(action.choice),
                   [this, index](int choice) {
                       setAction(index, [&](Action& each) {
                           each.choice = static_cast<model::PlaceChoice>(choice);
                       });
                   });
    const bool isGiven = action.choice == model::PlaceChoice::Given;
    QHBoxLayout* row = indentedRowIn(layout);
    if (!isGiven) {
        addPathField(row, m_scene, action.path, tr("of any path"), [this, index](model::PathId id) {
            setAction(index, [&](Action& each) { each.path = id; });
        });
    }
    if (isGiven || action.path == 0) {
        addPlaceField(row, m_scene, action.place, isGiven ? QString() : tr("with any name"),
                      [this, index](model::PlaceId id) {
                          setAction(index, [&](Action& each) { each.place = id; });
                      });
    }
}

void RuleEditor::addSendFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    QHBoxLayout* row = indentedRowIn(layout);
    addTextField(row, QString::fromStdString(action.event), tr("event"),
                 [this, index](const QString& text) {
                     setAction(index, [&](Action& each) { each.event = text.toStdString(); });
                 });
    addChoiceField(row, reachNames(), static_cast<int>(action.reach), [this, index](int reach) {
        setAction(index, [&](Action& each) { each.reach = static_cast<model::EventReach>(reach); });
    });
    row = indentedRowIn(layout);
    if (action.reach == model::EventReach::Near) {
        addNumber(row, index, &Action::metres, 0.0, 1000.0, tr(" m"));
    } else if (action.reach == model::EventReach::Tagged) {
        addTagField(row, m_scene, action.tag, [this, index](std::uint8_t tag) {
            setAction(index, [&](Action& each) { each.tag = tag; });
        });
    }
    addNumber(row, index, &Action::secondsPerMetre, 0.0, 60.0, tr(" s/m"), tr("at once"));
    addNumber(row, index, &Action::value, -1e6, 1e6, {});
}

/// Whom or what it is about.
void RuleEditor::addAimFields(QVBoxLayout* layout, std::size_t index, bool canBePlace)
{
    const Action& action = m_rule.actions[index];
    QHBoxLayout* row = indentedRowIn(layout);
    QStringList names = aimNames();
    if (!canBePlace && action.aim != model::ActionAim::Place) {
        names.removeLast();
    }
    addChoiceField(row, names, static_cast<int>(action.aim), [this, index](int aim) {
        setAction(index, [&](Action& each) { each.aim = static_cast<model::ActionAim>(aim); });
    });
    if (action.aim == model::ActionAim::Tagged) {
        addTagField(row, m_scene, action.tag, [this, index](std::uint8_t tag) {
            setAction(index, [&](Action& each) { each.tag = tag; });
        });
    } else if (action.aim == model::ActionAim::Place) {
        addPlaceField(row, m_scene, action.place, {}, [this, index](model::PlaceId id) {
            setAction(index, [&](Action& each) { each.place = id; });
        });
    }
}

void RuleEditor::addActionFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    const auto addPlace = [&](const QString& any) {
        addPlaceField(indentedRowIn(layout), m_scene, action.place, any,
                      [this, index](model::PlaceId id) {
                          setAction(index, [&](Action& each) { each.place = id; });
                      });
    };
    const auto addEdited = [&](float Action::*member, double high, const QString& suffix,
                               const QString& zero = {}) {
        addNumber(indentedRowIn(layout), index, member, 0.0, high, suffix, zero);
    };
    switch (action.kind) {
    case ActionKind::PlayClip: {
        QHBoxLayout* row = indentedRowIn(layout);
        addClipField(row, m_scene, action.clips, [this, index](const auto& clips) {
            setAction(index, [&](Action& each) { each.clips = clips; });
        });
        addChoiceField(row, {tr("once"), tr("for")}, action.isLooped ? 1 : 0,
                       [this, index](int choice) {
                           setAction(index, [&](Action& each) { each.isLooped = choice == 1; });
                       });
        if (action.isLooped) {
            addNumber(row, index, &Action::seconds, 0.0, 3600.0, tr(" s"));
        }
        break;
    }
    case ActionKind::FollowPath:
        addPathField(indentedRowIn(layout), m_scene, action.path, {},
                     [this, index](model::PathId path) {
                         setAction(index, [&](Action& each) { each.path = path; });
                     });
        break;
    case ActionKind::GoToPlace:
        addGoFields(layout, index);
        break;
    case ActionKind::TurnTo:
        addAimFields(layout, index, true);
        break;
    case ActionKind::LookAt:
        addAimFields(layout, index, true);
        addEdited(&Action::seconds, 3600.0, tr(" s"), tr("until something else comes"));
        break;
    case ActionKind::GoToPerson:
    case ActionKind::Follow: {
        addAimFields(layout, index, false);
        QHBoxLayout* row = indentedRowIn(layout);
        row->addWidget(new QLabel(tr("up to")));
        addNumber(row, index, &Action::metres, 0.0, 100.0, tr(" m"));
        addNumber(row, index, &Action::seconds, 0.0, 3600.0, tr(" s"),
                  action.kind == ActionKind::Follow ? tr("until something else comes")
                                                    : tr("however long"));
        break;
    }
    case ActionKind::LeaveScene:
        addPlace(tr("where they are"));
        break;
    case ActionKind::Appear:
        addPlace({});
        break;
    case ActionKind::Flee:
        addAimFields(layout, index, true);
        addEdited(&Action::metres, 1000.0, tr(" m"));
        break;
    case ActionKind::SitDown:
        addEdited(&Action::metres, 1000.0, tr(" m"), tr("however far"));
        break;
    case ActionKind::Wait:
        addEdited(&Action::seconds, 3600.0, tr(" s"));
        break;
    case ActionKind::WaitForEvent: {
        QHBoxLayout* row = indentedRowIn(layout);
        addTextField(row, QString::fromStdString(action.event), tr("event"),
                     [this, index](const QString& text) {
                         setAction(index, [&](Action& each) { each.event = text.toStdString(); });
                     });
        addNumber(row, index, &Action::seconds, 0.0, 3600.0, tr(" s"), tr("for ever"));
        break;
    }
    case ActionKind::SetSpeed:
        addEdited(&Action::value, 10.0, tr(" m/s"), tr("the event’s"));
        break;
    case ActionKind::AddTag:
    case ActionKind::RemoveTag:
        addTagField(indentedRowIn(layout), m_scene, action.tag, [this, index](std::uint8_t tag) {
            setAction(index, [&](Action& each) { each.tag = tag; });
        });
        break;
    case ActionKind::SendEvent:
        addSendFields(layout, index);
        break;
    case ActionKind::SetNumber:
    case ActionKind::AddToNumber: {
        QHBoxLayout* row = indentedRowIn(layout);
        addArtistNumberField(row, m_scene, action.number, [this, index](model::NumberId number) {
            setAction(index, [&](Action& each) { each.number = number; });
        });
        addNumber(row, index, &Action::value, -1e6, 1e6, {});
        break;
    }
    case ActionKind::Stop:
    case ActionKind::GoOn:
    case ActionKind::Again:
    case ActionKind::StandUp:
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
    QHBoxLayout* row = indentedRowIn(layout);
    row->addWidget(new QLabel(tr("pause")));
    addNumberField(row, static_cast<double>(m_rule.cooldownSeconds), 0.0, 3600.0, tr(" s"),
                   [this](double value) {
                       m_apply(
                           [&](Rule& each) { each.cooldownSeconds = static_cast<float>(value); });
                   });
    row = indentedRowIn(layout);
    row->addWidget(new QLabel(tr("at most")));
    addNumberField(
        row, static_cast<double>(m_rule.limit), 0.0, 1000.0, tr(" ×"),
        [this](double value) {
            m_apply([&](Rule& each) { each.limit = static_cast<std::uint32_t>(value); });
        },
        tr("as often as it comes"));
}

} // namespace crowd::widgets
