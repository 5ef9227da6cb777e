// SPDX-License-Identifier: MIT
#include "widgets/commands/StateCommands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>

#include "model/base/Translated.h"
#include "model/states/StateKeeping.h"

namespace crowd::widgets {

using model::State;

namespace {

struct StatesText
{
    Q_DECLARE_TR_FUNCTIONS(StateCommands)
};

const State* stateOf(const EditorState& state, model::StateId id)
{
    const auto& all = state.scene().states;
    const auto found = std::ranges::find(all, id, &State::id);
    return found == all.end() ? nullptr : &*found;
}

std::vector<model::IndividualId> peopleFor(const EditorState& state, StateReach reach,
                                           model::GroupId group)
{
    if (reach == StateReach::Group) {
        return peopleWith(state.scene().population, model::columns::group, group);
    }
    const auto ids =
        reach == StateReach::Selected ? state.selection().ids() : state.scene().population.ids();
    return {ids.begin(), ids.end()};
}

void editList(EditorState& state, const QString& text,
              const std::function<void(std::vector<State>&)>& change)
{
    std::vector<State> all = state.scene().states;
    change(all);
    state.document().edit(text, [&](model::SceneEdit& edit) { edit.setStates(std::move(all)); });
}

/// A long one would push what is said of it out of the status bar.
QString quoted(const std::string& name)
{
    constexpr qsizetype kMostSaid = 40;
    const QString text = QString::fromStdString(name);
    return text.size() > kMostSaid ? text.left(kMostSaid) + QChar(0x2026) : text;
}

void say(EditorState& state, const QString& name, const model::StateRecall& recall)
{
    QStringList said;
    const bool isRunning = state.session().isRunning();
    said << (recall.changed.empty() && isRunning
                 ? StatesText::tr(
                       "“%1” recalled in the run; the scene itself was like that already")
                       .arg(name)
             : recall.changed.empty()
                 ? StatesText::tr("“%1”: all of them are like that already").arg(name)
                 : StatesText::tr("“%1” recalled: %n characters changed", nullptr,
                                  static_cast<int>(recall.changed.size()))
                       .arg(name));
    for (const model::Message& note : recall.notes) {
        said << model::translated(note);
    }
    state.showStatus(said.join(QLatin1Char(' ')));
}

/// Those a state is recalled for; nothing: all of it.
using OnlyThese = std::optional<std::vector<model::IndividualId>>;

OnlyThese recallsFor(const EditorState& state)
{
    if (!state.recall().isForSelected) {
        return std::nullopt;
    }
    const auto ids = state.selection().ids();
    return std::vector<model::IndividualId>(ids.begin(), ids.end());
}

void recallInRun(EditorState& state, const State& kept, const OnlyThese& only)
{
    const model::ChangeOver change{kept.id, peopleOf(state.scene(), kept, only ? &*only : nullptr),
                                   kept.columns, timingNow(state)};
    if (change.ids.empty()) {
        state.showStatus((only ? StatesText::tr("“%1”: none of its characters is selected")
                               : StatesText::tr("“%1”: none of its characters is there"))
                             .arg(quoted(kept.name)));
    } else if (state.session().recall(change)) {
        state.noteRecallInRun(quoted(kept.name));
        state.showStatus(StatesText::tr("“%1” for %n characters, in this run alone: Stop gives "
                                        "the scene back",
                                        nullptr, static_cast<int>(change.ids.size()))
                             .arg(quoted(kept.name)));
    } else {
        state.showStatus(StatesText::tr("Wait until it is known where characters can walk, then "
                                        "recall the state."));
    }
}

} // namespace

model::RecallTiming timingNow(const EditorState& state)
{
    model::RecallTiming timing = state.recall().timing;
    const glm::vec3 forward = state.camera().forward();
    timing.stagger.headingRadians = std::atan2(forward.x, forward.z);
    return timing;
}

QString freeStateName(const model::Scene& scene)
{
    for (std::size_t number = scene.states.size() + 1;; ++number) {
        QString name = StatesText::tr("State %1").arg(number);
        if (model::findState(scene, name.toStdString()) == nullptr) {
            return name;
        }
    }
}

bool keepStateAs(EditorState& state, const QString& name, model::ColumnSet columns,
                 StateReach reach, model::GroupId group)
{
    const auto people = peopleFor(state, reach, group);
    if (people.empty() || columns.isEmpty()) {
        state.showStatus(columns.isEmpty() ? StatesText::tr("Tick what the state is to hold first.")
                         : reach == StateReach::Group
                             ? StatesText::tr("Nobody is in the group whose state could be kept.")
                         : reach == StateReach::Selected
                             ? StatesText::tr("Nobody is selected whose state could be kept.")
                             : StatesText::tr("Nobody is there yet whose state could be kept."));
        return false;
    }
    const model::Scene shown = state.session().shownScene();
    const auto outcome =
        state.document().edit(StatesText::tr("Keep “%1”").arg(name), [&](model::SceneEdit& edit) {
            putState(edit, keepState(shown, name.toStdString(), columns, people));
        });
    if (outcome != model::EditOutcome::Refused) {
        state.chooseState(state.scene().states.back().id);
        state.showStatus(StatesText::tr("“%1” keeps how %n characters are now", nullptr,
                                        static_cast<int>(people.size()))
                             .arg(name));
    }
    return outcome != model::EditOutcome::Refused;
}

void keepStateAnew(EditorState& state, model::StateId id)
{
    const State* before = stateOf(state, id);
    if (before == nullptr) {
        return;
    }
    std::vector<model::IndividualId> people = before->people->ids;
    std::erase_if(people, [&state](model::IndividualId each) {
        return state.scene().population.rowOf(each) == model::Population::npos;
    });
    State now = keepState(state.session().shownScene(), before->name, before->columns, people);
    now.id = id;
    const QString name = quoted(now.name);
    editList(state, StatesText::tr("Keep “%1” anew").arg(name), [&](std::vector<State>& all) {
        *std::ranges::find(all, id, &State::id) = std::move(now);
    });
    state.chooseState(id);
    state.showStatus(StatesText::tr("“%1” keeps how %n characters are now", nullptr,
                                    static_cast<int>(people.size()))
                         .arg(name));
}

void recallStateOf(EditorState& state, model::StateId id, RecallInto into)
{
    const State* found = stateOf(state, id);
    if (found == nullptr) {
        return;
    }
    const State kept = *found;
    state.chooseState(id);
    const OnlyThese only = recallsFor(state);
    if (only && only->empty()) {
        state.showStatus(StatesText::tr("Nobody is selected for whom “%1” could be recalled.")
                             .arg(quoted(kept.name)));
        return;
    }
    if (into == RecallInto::Run && state.transport().isPlaying()) {
        recallInRun(state, kept, only);
        return;
    }
    model::StateRecall recall;
    const auto outcome = state.document().edit(
        StatesText::tr("Recall “%1”").arg(quoted(kept.name)), [&](model::SceneEdit& edit) {
            recall =
                recallState(edit, kept, kept.columns, only ? &*only : nullptr, timingNow(state));
        });
    if (outcome != model::EditOutcome::Refused) {
        say(state, quoted(kept.name), recall);
    }
}

void setHeld(EditorState& state, model::StateId id, model::PropertyAspect aspect, bool isHeld)
{
    const State* before = stateOf(state, id);
    if (before == nullptr) {
        return;
    }
    model::ColumnSet columns;
    const model::ColumnSet meant = model::columnsOf(aspect);
    before->columns.forEach([&](model::ColumnId column) {
        if (isHeld || !meant.contains(column)) {
            columns.insert(column);
        }
    });
    meant.forEach([&](model::ColumnId column) {
        if (isHeld) {
            columns.insert(column);
        }
    });
    if (columns.isEmpty()) {
        state.showStatus(StatesText::tr("A state holds at least one of them."));
        return;
    }
    State now = withColumns(*before, columns, state.session().shownScene());
    editList(state, StatesText::tr("Change what a state holds"), [&](std::vector<State>& all) {
        *std::ranges::find(all, id, &State::id) = std::move(now);
    });
}

void removeState(EditorState& state, model::StateId id)
{
    editList(state, StatesText::tr("Remove a state"), [id](std::vector<State>& all) {
        std::erase_if(all, [id](const State& each) { return each.id == id; });
    });
}

bool renameState(EditorState& state, model::StateId id, const QString& name)
{
    const std::string text = name.simplified().toStdString();
    const State* same = model::findState(state.scene(), text);
    if (text.empty() || (same != nullptr && same->id != id)) {
        state.showStatus(text.empty() ? StatesText::tr("A state needs a name.")
                                      : StatesText::tr("There is a state “%1” already.").arg(name));
        return false;
    }
    editList(state, StatesText::tr("Rename a state"), [&](std::vector<State>& all) {
        if (const auto found = std::ranges::find(all, id, &State::id); found != all.end()) {
            found->name = text;
        }
    });
    return true;
}

void moveState(EditorState& state, model::StateId id, int by)
{
    editList(state, StatesText::tr("Move a state"), [&](std::vector<State>& all) {
        const auto found = std::ranges::find(all, id, &State::id);
        const auto place = found - all.begin();
        const auto to = place + by;
        if (found == all.end() || to < 0 || to >= std::ssize(all)) {
            return;
        }
        State moved = std::move(*found);
        all.erase(found);
        all.insert(all.begin() + to, std::move(moved));
    });
}

void selectPeopleOf(EditorState& state, model::StateId id)
{
    if (const State* found = stateOf(state, id)) {
        std::vector<model::IndividualId> people = found->people->ids;
        std::erase_if(people, [&state](model::IndividualId each) {
            return state.scene().population.rowOf(each) == model::Population::npos;
        });
        state.selection().set(people);
    }
}

} // namespace crowd::widgets
