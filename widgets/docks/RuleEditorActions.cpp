// SPDX-License-Identifier: MIT
#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/scene/RuleSequence.h"
#include "widgets/docks/RuleEditor.h"
#include "widgets/docks/RuleFields.h"
#include "widgets/docks/RuleTexts.h"

/// What a rule lets people do, line by line.
namespace crowd::widgets {

using model::Action;
using model::ActionKind;
using model::Rule;
using model::SettableProperty;

namespace {

/// With values that suit it.
void setKind(Action& action, ActionKind kind)
{
    action.kind = kind;
    if (kind == ActionKind::SitDown) {
        action.metres = 0.0F;
    } else if (kind == ActionKind::WaitForEvent) {
        action.seconds = 0.0F;
    } else if (kind == ActionKind::Follow || kind == ActionKind::GoToPerson) {
        // A whole arm's length further than two who talk: whom many follow must get out.
        action.metres = kind == ActionKind::Follow ? 2.5F : 1.5F;
        action.seconds = 0.0F;
    }
    if (kind == ActionKind::SetProperty) {
        action.value = 1.0F;
    }
    if (kind == ActionKind::Repeat || kind == ActionKind::OneOf) {
        action.times = 2;
        action.weight = 1.0F;
    }
    const bool isToPerson = kind == ActionKind::Follow || kind == ActionKind::GoToPerson;
    if (isToPerson && action.aim == model::ActionAim::Place) {
        action.aim = model::ActionAim::Sender;
    }
}

/// What they do with their bodies, where they go, in which order and when, what becomes of them.
std::vector<std::vector<int>> actionGroups()
{
    const std::vector<std::vector<ActionKind>> kinds{
        {ActionKind::PlayClip, ActionKind::TurnTo, ActionKind::LookAt, ActionKind::SitDown,
         ActionKind::StandUp},
        {ActionKind::FollowPath, ActionKind::GoToPlace, ActionKind::GoToPerson, ActionKind::Follow,
         ActionKind::Flee, ActionKind::Stop, ActionKind::GoOn, ActionKind::SetSpeed},
        {ActionKind::Wait, ActionKind::WaitForEvent, ActionKind::Repeat, ActionKind::OneOf,
         ActionKind::Again},
        {ActionKind::SendEvent, ActionKind::AddTag, ActionKind::RemoveTag, ActionKind::SetProperty,
         ActionKind::SetNumber, ActionKind::AddToNumber},
        {ActionKind::Appear, ActionKind::LeaveScene}};
    std::vector<std::vector<int>> groups;
    for (const std::vector<ActionKind>& group : kinds) {
        std::vector<int>& indices = groups.emplace_back();
        for (const ActionKind kind : group) {
            indices.push_back(static_cast<int>(kind));
        }
    }
    return groups;
}

} // namespace

QString RuleEditor::wordBefore(std::size_t index) const
{
    if (m_rule.actions[index].kind == ActionKind::OneOf) {
        return model::alternativesOf(m_rule.actions, index).front() == index ? tr("either")
                                                                             : tr("or");
    }
    const bool isFirst =
        index == 0 || model::parentOf(m_rule.actions, index) == index - 1; // of all, or in it
    return isFirst ? tr("do") : tr("then");
}

void RuleEditor::addAction(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    m_depth = action.depth;
    QHBoxLayout* row = rowIn(layout);
    row->addWidget(new QLabel(wordBefore(index)));
    addGroupedField(row, actionNames(), actionGroups(), static_cast<int>(action.kind),
                    [this, index](int kind) {
                        m_apply([&](Rule& each) {
                            setKind(each.actions[index], static_cast<ActionKind>(kind));
                            model::settleDepths(each.actions); // nothing may belong to it now
                        });
                    });
    const auto addMove = [&](Qt::ArrowType arrow, const QString& tip,
                             void (*shift)(model::Actions&, std::size_t)) {
        model::Actions moved = m_rule.actions;
        shift(moved, index);
        auto* button = new QToolButton(this);
        button->setArrowType(arrow);
        button->setAutoRaise(true);
        button->setFixedWidth(kSmallButton);
        button->setToolTip(tip);
        button->setEnabled(moved != m_rule.actions);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this,
                [this, index, shift] { m_apply([&](Rule& each) { shift(each.actions, index); }); });
    };
    if (m_rule.actions.size() > 1) {
        addMove(Qt::UpArrow, tr("Earlier, or into or out of what repeats"), &model::moveUp);
        addMove(Qt::DownArrow, tr("Later, or into or out of what repeats"), &model::moveDown);
    }
    addRemoveButton(
        row, model::isHead(action) ? tr("Remove this and what is in it") : tr("Remove this"),
        [this, index] { m_apply([&](Rule& each) { model::removeLine(each.actions, index); }); });
    addActionFields(layout, index);
    m_depth = 0;
}

/// What repeats, or is one of several.
void RuleEditor::addBlockFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    QHBoxLayout* row = indentedRowIn(layout);
    if (action.kind == ActionKind::Repeat) {
        addCountField(
            row, action.times, model::kMaxTimes, tr(" ×"),
            [this, index](std::uint32_t times) {
                setAction(index, [&](Action& each) { each.times = times; });
            },
            tr("for ever"));
    } else {
        row->addWidget(new QLabel(tr("how often")));
        addNumber(row, index, &Action::weight, 0.0, 1000.0, tr(" ×"));
        row->itemAt(row->count() - 1)
            ->widget()
            ->setToolTip(tr("How often it comes, against the others"));
    }
    addTextButton(row, "addInside", tr("+ in it"), tr("Adds something to do in it"),
                  [index](Rule& each) {
                      Action wait;
                      wait.kind = ActionKind::Wait;
                      model::addInside(each.actions, index, wait);
                  });
    if (action.kind == ActionKind::OneOf) {
        addTextButton(row, "addAlternative", tr("+ or…"), tr("Adds another one to choose among"),
                      [index](Rule& each) { model::addAlternative(each.actions, index); });
    }
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

/// Where they are, at one place, or at which of several exits.
void RuleEditor::addLeaveFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    const bool isGiven = action.choice == model::PlaceChoice::Given;
    const QStringList names{tr("where they are"), tr("at this place"), tr("at the nearest"),
                            tr("at the nearest free one"), tr("at the first free one")};
    const int chosen = isGiven ? (action.place != 0 ? 1 : 0) : static_cast<int>(action.choice) + 1;
    addChoiceField(indentedRowIn(layout), names, chosen, [this, index](int choice) {
        setAction(index, [&](Action& each) {
            const bool isHere = choice == 0;
            each.choice = choice < 2 ? model::PlaceChoice::Given
                                     : static_cast<model::PlaceChoice>(choice - 1);
            each.path = choice < 2 || each.path == model::kNotChosen ? 0 : each.path;
            each.place = isHere || choice > 1 ? 0 : model::kNotChosen;
        });
    });
    const auto setPlace = [this, index](model::PlaceId id) {
        setAction(index, [&](Action& each) { each.place = id; });
    };
    if (!isGiven) {
        addPathField(indentedRowIn(layout), m_scene, action.path, tr("of all exits"),
                     [this, index](model::PathId id) {
                         setAction(index, [&](Action& each) { each.path = id; });
                     });
    }
    if (isGiven ? action.place != 0 : action.path == 0) {
        addPlaceField(indentedRowIn(layout), m_scene, action.place,
                      isGiven ? QString() : tr("with any name"), setPlace);
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
    if (action.reach == model::EventReach::Near) {
        addNumber(labelledRowIn(layout, tr("within"), tr("Whoever is nearer hears it")), index,
                  &Action::metres, 0.0, 1000.0, tr(" m"));
    } else if (action.reach == model::EventReach::Tagged) {
        addTagField(indentedRowIn(layout), m_scene, action.tag, [this, index](std::uint8_t tag) {
            setAction(index, [&](Action& each) { each.tag = tag; });
        });
    }
    addNumber(labelledRowIn(layout, tr("runs at"), tr("How long it takes from one to the next")),
              index, &Action::secondsPerMetre, 0.0, 60.0, tr(" s/m"), tr("once for all"));
    addNumber(labelledRowIn(layout, tr("its number"),
                            tr("Rules that hear it can ask for it, or walk as fast")),
              index, &Action::value, -1e6, 1e6, {});
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

void RuleEditor::addPropertyFields(QVBoxLayout* layout, std::size_t index)
{
    const Action& action = m_rule.actions[index];
    const auto setClips = [this, index](const std::vector<model::ClipWeight>& clips) {
        setAction(index, [&](Action& each) { each.clips = clips; });
    };
    addChoiceField(indentedRowIn(layout), settableNames(), static_cast<int>(action.property),
                   [this, index](int property) {
                       setAction(index, [&](Action& each) {
                           each.property = static_cast<SettableProperty>(property);
                           each.value = each.property == SettableProperty::Phase ? 0.0F : 1.0F;
                       });
                   });
    QHBoxLayout* row = indentedRowIn(layout);
    const auto addTo = [row] { row->addWidget(new QLabel(tr("to"))); };
    if (action.property != SettableProperty::Tint) {
        addTo();
    }
    switch (action.property) {
    case SettableProperty::Tint:
        addSlotField(row, m_scene, action.slot, [this, index](const std::string& slot) {
            setAction(index, [&](Action& each) { each.slot = slot; });
        });
        addTo();
        addTintField(row, action.tint, [this, index](const model::Tint& tint) {
            setAction(index, [&](Action& each) { each.tint = tint; });
        });
        break;
    case SettableProperty::Height:
        addNumber(row, index, &Action::value, 0.05, 20.0, tr(" ×"));
        break;
    case SettableProperty::PlaybackSpeed:
        addNumber(row, index, &Action::value, 0.0, 100.0, tr(" ×"));
        break;
    case SettableProperty::Clip:
        addClipField(row, m_scene, action.clips, setClips);
        addClipWeights(layout, action.clips, setClips);
        break;
    case SettableProperty::Phase:
        addNumber(row, index, &Action::value, 0.0, 1.0, {});
        break;
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
    const auto addEdited = [&](const QString& label, float Action::*member, double high,
                               const QString& suffix, const QString& zero = {}) {
        addNumber(labelledRowIn(layout, label), index, member, 0.0, high, suffix, zero);
    };
    const auto setClips = [this, index](const std::vector<model::ClipWeight>& clips) {
        setAction(index, [&](Action& each) { each.clips = clips; });
    };
    switch (action.kind) {
    case ActionKind::PlayClip: {
        QHBoxLayout* row = indentedRowIn(layout);
        addClipField(row, m_scene, action.clips, setClips);
        addChoiceField(row, {tr("once"), tr("for")}, action.isLooped ? 1 : 0,
                       [this, index](int choice) {
                           setAction(index, [&](Action& each) { each.isLooped = choice == 1; });
                       });
        if (action.isLooped) {
            addNumber(row, index, &Action::seconds, 0.0, 3600.0, tr(" s"));
        }
        addClipWeights(layout, action.clips, setClips);
        break;
    }
    case ActionKind::SetProperty:
        addPropertyFields(layout, index);
        break;
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
        addEdited(tr("for"), &Action::seconds, 3600.0, tr(" s"), tr("until something else comes"));
        break;
    case ActionKind::GoToPerson:
    case ActionKind::Follow:
        addAimFields(layout, index, false);
        addNumber(labelledRowIn(layout, tr("up to"), tr("How near they come")), index,
                  &Action::metres, 0.0, 100.0, tr(" m"));
        addEdited(action.kind == ActionKind::Follow ? tr("for") : tr("at most"), &Action::seconds,
                  3600.0, tr(" s"),
                  action.kind == ActionKind::Follow ? tr("until something else comes")
                                                    : tr("however long"));
        break;
    case ActionKind::LeaveScene:
        addLeaveFields(layout, index);
        break;
    case ActionKind::Appear:
        addPlace({});
        break;
    case ActionKind::Flee:
        addAimFields(layout, index, true);
        addEdited(tr("for"), &Action::metres, 1000.0, tr(" m"));
        break;
    case ActionKind::SitDown:
        addEdited(tr("within"), &Action::metres, 1000.0, tr(" m"), tr("however far"));
        break;
    case ActionKind::Wait:
        addEdited(tr("about"), &Action::seconds, 3600.0, tr(" s"));
        break;
    case ActionKind::WaitForEvent: {
        QHBoxLayout* row = indentedRowIn(layout);
        addTextField(row, QString::fromStdString(action.event), tr("event"),
                     [this, index](const QString& text) {
                         setAction(index, [&](Action& each) { each.event = text.toStdString(); });
                     });
        addEdited(tr("at most"), &Action::seconds, 3600.0, tr(" s"), tr("for ever"));
        break;
    }
    case ActionKind::SetSpeed:
        addEdited(tr("to"), &Action::value, 10.0, tr(" m/s"), tr("the event’s number"));
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
        row->addWidget(new QLabel(action.kind == ActionKind::SetNumber ? tr("to") : tr("by")));
        addNumber(row, index, &Action::value, -1e6, 1e6, {});
        break;
    }
    case ActionKind::Repeat:
    case ActionKind::OneOf:
        addBlockFields(layout, index);
        break;
    case ActionKind::Stop:
    case ActionKind::GoOn:
    case ActionKind::Again:
    case ActionKind::StandUp:
        break;
    }
}

} // namespace crowd::widgets
