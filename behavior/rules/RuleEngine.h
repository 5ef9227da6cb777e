// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "behavior/base/Problem.h"
#include "behavior/rules/RuleHost.h"
#include "behavior/rules/RuleState.h"
#include "model/population/Population.h"
#include "model/rules/Rule.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// Runs rules over people. Owns their state and has the stages work on it, in the same order in
/// each step: events that are due are delivered (EventDelivery), triggers evaluated (RuleTriggers),
/// and whoever is busy with a rule goes on with its actions (ActionRunner). Serial, so that the
/// same scene and the same events give the same bits. Sent events arrive at the next step at the
/// earliest: no cycle of events can close within one. World frame, metres, seconds.
class RuleEngine
{
public:
    /// Takes over rules and places; sequences that run go on where their rule is unchanged. When
    /// numbers were kept, those that everybody has here stay.
    void setRules(const model::Scene& scene, bool areNumbersKept = false);
    /// Agents are other ones now; keep[i] is the former agent, or kNoAgent for a new one. Tags come
    /// from the scene.
    void setPeople(const model::Population& people, std::span<const std::uint32_t> keep);
    void setTags(std::uint32_t agent, std::uint64_t tags) { m_state.agents[agent].tags = tags; }
    [[nodiscard]] std::uint64_t tags(std::uint32_t agent) const
    {
        return m_state.agents[agent].tags;
    }
    /// Of the artist's numbers, as it is now; 0 where there is none of that id.
    [[nodiscard]] float number(std::uint32_t agent, model::NumberId id) const
    {
        return m_state.numbers.value(agent, id);
    }
    /// See ArtistNumbers::change.
    void setNumber(std::uint32_t agent, model::NumberId id, float value)
    {
        (void)m_state.numbers.change(agent, id, value, false);
    }
    /// See ArtistNumbers::changed.
    [[nodiscard]] std::shared_ptr<const std::vector<OwnNumber>> ownNumbers()
    {
        return m_state.numbers.changed(m_state.agents.ids());
    }

    /// Somebody begins to take on a state: in the next step rules hear of it.
    void noteRecalled(std::uint32_t agent, std::uint32_t state)
    {
        m_recalled.push_back({agent, state});
    }

    /// In the step after the next rules hear of it: whoever has it of a rule is free for others
    /// by then.
    void noteFeature(std::uint32_t agent, std::uint32_t feature)
    {
        m_changedFeatures.push_back({agent, feature});
    }

    /// As long as the session's; 30 before it is said.
    void setStepsPerSecond(std::uint32_t steps) { m_stepsPerSecond = steps; }
    void step(RuleHost& host, std::uint64_t step);
    void send(const std::string& event, float payload, std::uint32_t agent,
              const glm::vec3& origin);

    /// How often a rule fired in this session.
    [[nodiscard]] std::uint64_t count(model::RuleId rule) const { return m_state.log.count(rule); }
    [[nodiscard]] const std::map<model::RuleId, std::uint64_t>& counts() const
    {
        return m_state.log.counts();
    }
    /// See FiringLog::take.
    [[nodiscard]] std::vector<RuleFired> takeLog() { return m_state.log.take(); }
    /// What went wrong while running, each once.
    [[nodiscard]] const std::vector<Problem>& problems() const { return m_state.problems.all(); }
    /// Place that counts somebody as its guest; 0: none does.
    [[nodiscard]] model::PlaceId heldPlace(std::uint32_t agent) const
    {
        return m_state.agents[agent].heldPlace;
    }
    [[nodiscard]] bool isBusy(std::uint32_t agent) const
    {
        return m_state.agents[agent].rule != kNoRule;
    }
    /// Wherever he goes next, it is to no place that rules know of.
    void forgetGoal(std::uint32_t agent) { m_state.agents[agent].errand.goal = 0; }
    /// For whom a rule fired within the last half second: agents, ascending.
    [[nodiscard]] std::vector<std::uint32_t> lit() const { return m_state.log.highlighted(); }
    [[nodiscard]] bool isEmpty() const { return m_state.rules.empty(); }

private:
    void beginStep(std::uint64_t step);

    RuleState m_state;
    std::vector<RecalledState> m_recalled;         ///< since the last step
    std::vector<ChangedFeature> m_dueFeatures;     ///< for the next step
    std::vector<ChangedFeature> m_changedFeatures; ///< for the one after it
    std::uint32_t m_stepsPerSecond = 30;
};

} // namespace crowd::behavior
