// SPDX-License-Identifier: MIT
#include "app/python/ScriptStates.h"

#include <algorithm>

#include "app/python/ColumnRules.h"
#include "model/base/ShownText.h"
#include "model/brush/ByteChange.h"
#include "model/describe/FieldChecks.h"
#include "model/population/Properties.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"

namespace crowd::app {

using namespace model;

namespace {

Error noState(const Scene& scene, const std::string& name)
{
    std::string known;
    for (const State& each : scene.states) {
        known += (known.empty() ? "" : ", ") + shortened(each.name);
    }
    return Error{"There is no state \"" + shortened(name) +
                 "\"; there are: " + (known.empty() ? "none yet" : known) + '.'};
}

Result<void> checkName(const std::string& name)
{
    if (QString::fromStdString(name).simplified().isEmpty()) {
        return Error{"A state needs a name."};
    }
    return {};
}

/// A step over a copy of the list.
Result<void> editStates(ScriptScene& script, const char* text,
                        const std::function<Result<void>(std::vector<State>&)>& change)
{
    return script.onDocument([&]() -> Result<void> {
        std::vector<State> all = script.document().scene().states;
        if (auto changed = change(all); !changed) {
            return changed;
        }
        return script.edit(stepText(text),
                           [&](SceneEdit& open) { open.setStates(std::move(all)); });
    });
}

std::vector<IndividualId> everybody(const Scene& scene)
{
    const auto ids = scene.population.ids();
    return {ids.begin(), ids.end()};
}

} // namespace

Result<ColumnSet> stateColumns(const std::vector<std::string>* names)
{
    if (names == nullptr) {
        return usualStateColumns();
    }
    ColumnSet columns;
    for (const std::string& name : *names) {
        if (name == "tint") {
            std::ranges::for_each(kTintColumns, [&](ColumnId tint) { columns.insert(tint); });
        } else if (const PropertyInfo* property = findProperty(name)) {
            columns.insert(property->id);
        } else {
            return Error{"columns: there is no column \"" + shortened(name) +
                         "\"; crowdbrush.properties() has their names."};
        }
    }
    if (columns.isEmpty()) {
        return Error{"columns names none: a state holds at least one."};
    }
    return columns;
}

Result<void> saveState(ScriptScene& script, const std::string& name, ColumnSet columns,
                       const std::vector<IndividualId>* ids)
{
    if (auto sound = checkName(name); !sound) {
        return sound;
    }
    return script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        const std::vector<IndividualId> people = ids != nullptr ? *ids : everybody(now);
        if (auto alive = checkAlive(now, people); !alive) {
            return alive;
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Keep a state")),
                           [&](SceneEdit& open) {
                               putState(open, keepState(open.scene(), name, columns, people));
                           });
    });
}

Result<ChangeOver> changeOverTo(const Scene& scene, const std::string& name,
                                const RecallOrder& order)
{
    const State* found = findState(scene, name);
    if (found == nullptr) {
        return noState(scene, name);
    }
    if (auto alive = order.ids ? checkAlive(scene, *order.ids) : Result<void>(); !alive) {
        return alive.error();
    }
    if (auto sound = checkFields(fieldsOf<RecallTiming>(), &order.timing, {}); !sound) {
        return sound.error();
    }
    return ChangeOver{found->id, peopleOf(scene, *found, order.ids ? &*order.ids : nullptr),
                      recalledColumns(*found, order.columns.value_or(found->columns)),
                      order.timing};
}

Result<StateRecall> recallState(ScriptScene& script, const std::string& name,
                                const RecallOrder& order)
{
    StateRecall recall;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        const auto change = changeOverTo(now, name, order);
        if (!change) {
            return change.error();
        }
        script.noteChangeOver(change.value());
        const State state = *findState(now, name);
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Recall a state")),
                           [&](SceneEdit& open) {
                               recall = model::recallState(open, state, change.value().columns,
                                                           &change.value().ids, order.timing);
                           });
    });
    if (!done) {
        return done.error();
    }
    return recall;
}

Result<void> removeState(ScriptScene& script, const std::string& name)
{
    return editStates(
        script, QT_TRANSLATE_NOOP("Script", "Remove a state"),
        [&](std::vector<State>& all) -> Result<void> {
            if (std::erase_if(all, [&](const State& each) { return each.name == name; }) == 0) {
                return noState(script.document().scene(), name);
            }
            return {};
        });
}

Result<void> renameState(ScriptScene& script, const std::string& name, const std::string& to)
{
    if (auto sound = checkName(to); !sound) {
        return sound;
    }
    return editStates(script, QT_TRANSLATE_NOOP("Script", "Rename a state"),
                      [&](std::vector<State>& all) -> Result<void> {
                          const auto state = std::ranges::find(all, name, &State::name);
                          if (state == all.end()) {
                              return noState(script.document().scene(), name);
                          }
                          if (name != to && std::ranges::find(all, to, &State::name) != all.end()) {
                              return Error{"There is a state \"" + shortened(to) + "\" already."};
                          }
                          state->name = to;
                          return {};
                      });
}

Result<void> arrangeStates(ScriptScene& script, const std::vector<std::string>& names)
{
    return editStates(script, QT_TRANSLATE_NOOP("Script", "Arrange states"),
                      [&](std::vector<State>& all) -> Result<void> {
                          std::vector<State> arranged;
                          for (const std::string& name : names) {
                              const auto state = std::ranges::find(all, name, &State::name);
                              if (state == all.end()) {
                                  return noState(script.document().scene(), name);
                              }
                              arranged.push_back(std::move(*state));
                              all.erase(state);
                          }
                          if (!all.empty()) {
                              return Error{"arrange wants the names of all states: \"" +
                                           shortened(all.front().name) + "\" is not among them."};
                          }
                          all = std::move(arranged);
                          return {};
                      });
}

Result<void> setStates(ScriptScene& script, const std::string& text)
{
    Result<Scene> read = projectFromText(text);
    if (!read) {
        return read.error();
    }
    return editStates(script, QT_TRANSLATE_NOOP("Script", "Change states"),
                      [&](std::vector<State>& all) -> Result<void> {
                          all = std::move(read.value().states);
                          return {};
                      });
}

std::string statesText(const std::vector<State>& states)
{
    Scene scene;
    scene.states = states;
    const Result<std::string> text = projectToText(scene);
    return text ? text.value() : std::string();
}

} // namespace crowd::app
