// SPDX-License-Identifier: MIT
#include "app/record/StateScript.h"

#include <algorithm>

#include "app/python/ScriptStates.h"
#include "app/record/ScriptText.h"
#include "model/states/StateKeeping.h"

namespace crowd::app {

using namespace model;

namespace {

std::string columnNames(ColumnSet columns)
{
    std::vector<std::string> names;
    columns.forEach([&names](ColumnId column) {
        names.push_back(pythonText(std::string(columnInfo(column).name)));
    });
    return pythonList(names, kIndent);
}

/// The list as scripts would have it, with what they say to get there.
class Steps
{
public:
    Steps(const std::vector<State>& before, const Scene& after) : m_states(before), m_scene(after)
    {
    }

    void removeOthers();
    void rename();
    void keep();
    void arrange();
    [[nodiscard]] bool isThere() const { return m_states == m_scene.states; }
    [[nodiscard]] std::vector<std::string> take() { return std::move(m_lines); }

private:
    std::vector<State> m_states;
    const Scene& m_scene;
    std::vector<std::string> m_lines;
};

void Steps::removeOthers()
{
    std::erase_if(m_states, [this](const State& each) {
        const bool isGone =
            std::ranges::find(m_scene.states, each.id, &State::id) == m_scene.states.end();
        if (isGone) {
            m_lines.push_back("del scene.states[" + pythonText(each.name) + "]\n");
        }
        return isGone;
    });
}

void Steps::rename()
{
    for (State& each : m_states) {
        const auto now = std::ranges::find(m_scene.states, each.id, &State::id);
        if (now->name != each.name) {
            m_lines.push_back("scene.states.rename(" + pythonText(each.name) + ", " +
                              pythonText(now->name) + ")\n");
            each.name = now->name;
        }
    }
}

void Steps::keep()
{
    for (const State& now : m_scene.states) {
        const auto before = std::ranges::find(m_states, now.id, &State::id);
        if (before != m_states.end() && *before == now) {
            continue;
        }
        const auto& ids = now.people->ids;
        const bool areThere = std::ranges::all_of(ids, [this](IndividualId id) {
            return m_scene.population.rowOf(id) != Population::npos;
        });
        if (!areThere) {
            return;
        }
        State kept = keepState(m_scene, now.name, now.columns, ids);
        kept.id = before == m_states.end() ? freeStateId(m_states, m_scene) : now.id;
        m_lines.push_back("scene.save_state(" + pythonText(now.name) + ", columns=" +
                          columnNames(now.columns) + ", ids=" + pythonIds(ids, kIndent) + ")\n");
        if (before == m_states.end()) {
            m_states.push_back(std::move(kept));
        } else {
            *before = std::move(kept);
        }
    }
}

void Steps::arrange()
{
    const auto idsOf = [](const std::vector<State>& states) {
        std::vector<StateId> ids;
        ids.reserve(states.size());
        for (const State& each : states) {
            ids.push_back(each.id);
        }
        return ids;
    };
    if (idsOf(m_states) == idsOf(m_scene.states) || m_states.size() != m_scene.states.size()) {
        return;
    }
    std::vector<std::string> names;
    std::vector<State> arranged;
    for (const State& now : m_scene.states) {
        names.push_back(pythonText(now.name));
        arranged.push_back(*std::ranges::find(m_states, now.id, &State::id));
    }
    m_states = std::move(arranged);
    m_lines.push_back("scene.states.arrange(" + pythonList(names, kIndent) + ")\n");
}

/// Scripts know states by their names.
bool areNamesDifferent(const std::vector<State>& states)
{
    std::vector<std::string> names;
    names.reserve(states.size());
    for (const State& each : states) {
        names.push_back(each.name);
    }
    std::ranges::sort(names);
    return std::ranges::adjacent_find(names) == names.end();
}

} // namespace

std::vector<std::string> stateLines(const std::vector<State>& before, const Scene& after)
{
    if (areNamesDifferent(before) && areNamesDifferent(after.states)) {
        Steps steps(before, after);
        steps.removeOthers();
        steps.rename();
        steps.keep();
        steps.arrange();
        if (steps.isThere()) {
            return steps.take();
        }
    }
    return {"scene.states.set_text(" + pythonText(statesText(after.states)) + ")\n"};
}

} // namespace crowd::app
