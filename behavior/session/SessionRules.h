// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "behavior/rules/RuleHost.h"
#include "behavior/session/SessionParts.h"

namespace crowd::behavior {

/// What rules ask of the people in a session and let them do: hands each on to the component whose
/// affair it is. Refers to the parts.
class SessionRules : public RuleHost
{
public:
    explicit SessionRules(SessionParts& parts) : m_parts(parts) {}

    [[nodiscard]] std::size_t agents() const override { return m_parts.agents.size(); }
    [[nodiscard]] glm::vec3 position(std::uint32_t agent) const override;
    [[nodiscard]] model::IndividualId id(std::uint32_t agent) const override;
    [[nodiscard]] model::TemplateId templateOf(std::uint32_t agent) const override;
    [[nodiscard]] std::uint32_t group(std::uint32_t agent) const override;
    [[nodiscard]] bool isSeated(std::uint32_t agent) const override;
    [[nodiscard]] bool isGone(std::uint32_t agent) const override;
    [[nodiscard]] model::PathId pathOf(std::uint32_t agent) const override;
    [[nodiscard]] std::span<const std::uint8_t> travelEvents() const override;
    [[nodiscard]] model::PlaceId reachedPlace(std::uint32_t agent) const override;
    float play(std::uint32_t agent, const std::string& clip, bool isLooped) override;
    void endClip(std::uint32_t agent) override;
    bool follow(std::uint32_t agent, model::PathId path) override;
    [[nodiscard]] glm::vec3 reached(const glm::vec3& from, const glm::vec3& point) const override;
    [[nodiscard]] float wayMetres(const glm::vec3& from, const glm::vec3& to,
                                  float within) const override;
    void sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast) override;
    void stop(std::uint32_t agent) override;
    void goOn(std::uint32_t agent) override;
    void setPace(std::uint32_t agent, float metresPerSecond) override;
    void turnTo(std::uint32_t agent, const glm::vec3& point) override;
    void leave(std::uint32_t agent) override { m_parts.leave(agent); }
    void appear(std::uint32_t agent, const glm::vec3& point) override;
    [[nodiscard]] float speed(std::uint32_t agent) const override;
    [[nodiscard]] glm::vec2 wantedVelocity(std::uint32_t agent) const override;
    bool sit(std::uint32_t agent, float metres) override;
    [[nodiscard]] bool hasSeats() override { return m_parts.seating.hasSeats(); }
    [[nodiscard]] bool isSittingDown(std::uint32_t agent) const override;
    float standUp(std::uint32_t agent) override { return m_parts.seating.standUp(agent); }
    void leaveSeat(std::uint32_t agent) override { m_parts.seating.leaveSeat(agent); }
    [[nodiscard]] float property(std::uint32_t agent,
                                 model::ComparedProperty property) const override;
    [[nodiscard]] bool showsClip(std::uint32_t agent, const std::string& clip) const override;
    void setProperty(std::uint32_t agent, const model::actions::SetProperty& action,
                     const std::string& clip) override;
    bool takeOnFeature(std::uint32_t agent, std::uint32_t feature) override;
    [[nodiscard]] bool bears(std::uint32_t agent, std::uint32_t feature) const override;
    bool takeOnState(std::uint32_t agent, const model::actions::TakeOnState& action) override;
    bool tellLight(const model::actions::TellLight& action) override;
    void noteTags(std::uint32_t agent, std::uint64_t tags) override;

private:
    void setTint(std::uint32_t agent, const model::actions::SetProperty& action);

    SessionParts& m_parts;
};

} // namespace crowd::behavior
