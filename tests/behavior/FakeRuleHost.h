// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "behavior/rules/RuleHost.h"

namespace crowd::testing {

/// People whom rules can ask and command without a session: they stand in a row two metres apart,
/// individual i + 1 in template 1, and do nothing but what a test writes. What rules have them do
/// is written down, one line each.
class FakeRuleHost : public behavior::RuleHost
{
public:
    explicit FakeRuleHost(std::size_t people)
        : positions(people), gone(people), seated(people), events(people), paths(people),
          speeds(people)
    {
        for (std::size_t i = 0; i < people; ++i) {
            positions[i].x = 2.0F * static_cast<float>(i);
        }
    }

    [[nodiscard]] std::size_t agents() const override { return positions.size(); }
    [[nodiscard]] glm::vec3 position(std::uint32_t agent) const override
    {
        return positions[agent];
    }
    [[nodiscard]] model::IndividualId id(std::uint32_t agent) const override { return agent + 1; }
    [[nodiscard]] model::TemplateId templateOf(std::uint32_t /*agent*/) const override { return 1; }
    [[nodiscard]] std::uint32_t group(std::uint32_t agent) const override { return agent % 2; }
    [[nodiscard]] bool isSeated(std::uint32_t agent) const override { return seated[agent] != 0; }
    [[nodiscard]] bool isGone(std::uint32_t agent) const override { return gone[agent] != 0; }
    [[nodiscard]] model::PathId pathOf(std::uint32_t agent) const override { return paths[agent]; }
    [[nodiscard]] std::span<const std::uint8_t> travelEvents() const override { return events; }
    [[nodiscard]] model::PlaceId reachedPlace(std::uint32_t /*agent*/) const override { return 0; }
    float play(std::uint32_t agent, const std::string& clip, bool /*isLooped*/) override
    {
        note(agent, "play " + clip);
        return clipSeconds;
    }
    void endClip(std::uint32_t agent) override { note(agent, "end clip"); }
    bool follow(std::uint32_t agent, model::PathId path) override
    {
        note(agent, "follow");
        paths[agent] = path;
        return true;
    }
    [[nodiscard]] glm::vec3 reached(const glm::vec3& /*from*/,
                                    const glm::vec3& point) const override
    {
        return point;
    }
    [[nodiscard]] float wayMetres(const glm::vec3& from, const glm::vec3& to,
                                  float /*within*/) const override
    {
        return glm::length(to - from);
    }
    void sendTo(std::uint32_t agent, const glm::vec3& point, float /*atLeast*/) override
    {
        note(agent, "send");
        sentTo = point;
    }
    void stop(std::uint32_t agent) override { note(agent, "stop"); }
    void goOn(std::uint32_t agent) override { note(agent, "go on"); }
    void setPace(std::uint32_t agent, float /*metresPerSecond*/) override { note(agent, "pace"); }
    void turnTo(std::uint32_t agent, const glm::vec3& /*point*/) override { note(agent, "turn"); }
    void leave(std::uint32_t agent) override { gone[agent] = 1; }
    void appear(std::uint32_t agent, const glm::vec3& point) override
    {
        gone[agent] = 0;
        positions[agent] = point;
    }
    [[nodiscard]] float speed(std::uint32_t agent) const override { return speeds[agent]; }
    [[nodiscard]] glm::vec2 wantedVelocity(std::uint32_t /*agent*/) const override { return {}; }
    bool sit(std::uint32_t /*agent*/, float /*metres*/) override { return false; }
    [[nodiscard]] bool hasSeats() override { return false; }
    [[nodiscard]] bool isSittingDown(std::uint32_t /*agent*/) const override { return false; }
    float standUp(std::uint32_t /*agent*/) override { return 1.0F; }
    void leaveSeat(std::uint32_t agent) override { seated[agent] = 0; }
    [[nodiscard]] float property(std::uint32_t /*agent*/,
                                 model::ComparedProperty /*property*/) const override
    {
        return 1.8F;
    }
    [[nodiscard]] bool showsClip(std::uint32_t /*agent*/,
                                 const std::string& /*clip*/) const override
    {
        return false;
    }
    void setProperty(std::uint32_t agent, const model::actions::SetProperty& /*action*/,
                     const std::string& /*clip*/) override
    {
        note(agent, "set");
    }
    bool takeOnState(std::uint32_t agent, const model::actions::TakeOnState& /*action*/) override
    {
        note(agent, "state");
        return true;
    }
    bool tellLight(const model::actions::TellLight& /*action*/) override { return true; }
    bool takeOnFeature(std::uint32_t agent, std::uint32_t /*feature*/) override
    {
        note(agent, "feature");
        return true;
    }
    [[nodiscard]] bool bears(std::uint32_t /*agent*/, std::uint32_t /*feature*/) const override
    {
        return false;
    }
    void noteTags(std::uint32_t agent, std::uint64_t /*tags*/) override { note(agent, "tags"); }

    std::vector<glm::vec3> positions;
    std::vector<std::uint8_t> gone;
    std::vector<std::uint8_t> seated;
    std::vector<std::uint8_t> events;
    std::vector<model::PathId> paths;
    std::vector<float> speeds;
    float clipSeconds = 1.5F;
    glm::vec3 sentTo{0.0F};
    std::vector<std::string> done; ///< "AGENT WHAT"

private:
    void note(std::uint32_t agent, const std::string& what)
    {
        done.push_back(std::to_string(agent) + " " + what);
    }
};

} // namespace crowd::testing
