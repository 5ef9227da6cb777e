// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/population/Columns.h"
#include "model/rules/Rule.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// What rules ask of people and let them do: all that they know of the session that runs them, so
/// that they can be tried without one. Agents count from 0. World frame, metres, seconds, radians.
/// Called by one thread, between two steps of the crowd; `agent` is below agents().
class RuleHost
{
public:
    virtual ~RuleHost() = default;
    [[nodiscard]] virtual std::size_t agents() const = 0;
    [[nodiscard]] virtual glm::vec3 position(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual model::IndividualId id(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual model::TemplateId templateOf(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual std::uint32_t group(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual bool isSeated(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual bool isGone(std::uint32_t agent) const = 0;
    [[nodiscard]] virtual model::PathId pathOf(std::uint32_t agent) const = 0;
    /// TravelEvent bits of the last step, by agent.
    [[nodiscard]] virtual std::span<const std::uint8_t> travelEvents() const = 0;
    [[nodiscard]] virtual model::PlaceId reachedPlace(std::uint32_t agent) const = 0;
    /// Seconds that the clip takes; below 0: there is no such clip.
    virtual float play(std::uint32_t agent, const std::string& clip, bool isLooped) = 0;
    virtual void endClip(std::uint32_t agent) = 0;
    /// False, and nothing changes: there is no such path.
    virtual bool follow(std::uint32_t agent, model::PathId path) = 0;
    /// `point`, or as near to it as one gets straight on from `from`.
    [[nodiscard]] virtual glm::vec3 reached(const glm::vec3& from,
                                            const glm::vec3& point) const = 0;
    /// Of the way from one point to another, metres; infinite where it ends further than `within`
    /// from there.
    [[nodiscard]] virtual float wayMetres(const glm::vec3& from, const glm::vec3& to,
                                          float within) const = 0;
    /// At his own pace, or at `atLeast` (m/s) where that is faster.
    virtual void sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast) = 0;
    virtual void stop(std::uint32_t agent) = 0;
    virtual void goOn(std::uint32_t agent) = 0;
    virtual void setPace(std::uint32_t agent, float metresPerSecond) = 0;
    virtual void turnTo(std::uint32_t agent, const glm::vec3& point) = 0;
    virtual void leave(std::uint32_t agent) = 0;
    /// Is there from now on, also after leaving.
    virtual void appear(std::uint32_t agent, const glm::vec3& point) = 0;
    [[nodiscard]] virtual float speed(std::uint32_t agent) const = 0; ///< m/s, smoothed
    /// Along the ground, m/s, whether or not others let him; 0 where he wants to stay.
    [[nodiscard]] virtual glm::vec2 wantedVelocity(std::uint32_t agent) const = 0;
    /// On the nearest free seat within so many metres (0: however far). False: there is none.
    virtual bool sit(std::uint32_t agent, float metres) = 0;
    [[nodiscard]] virtual bool hasSeats() = 0;
    /// On the way to a seat.
    [[nodiscard]] virtual bool isSittingDown(std::uint32_t agent) const = 0;
    /// Begins to stand up: seconds that it takes.
    virtual float standUp(std::uint32_t agent) = 0;
    /// Has stood up.
    virtual void leaveSeat(std::uint32_t agent) = 0;
    /// Of all but the clip.
    [[nodiscard]] virtual float property(std::uint32_t agent,
                                         model::ComparedProperty property) const = 0;
    [[nodiscard]] virtual bool showsClip(std::uint32_t agent, const std::string& clip) const = 0;
    /// `clip` is the one that was drawn. What somebody's template has not stays as it is.
    virtual void setProperty(std::uint32_t agent, const model::actions::SetProperty& action,
                             const std::string& clip) = 0;
    /// By the end of this step. False: there is no such state.
    virtual bool takeOnState(std::uint32_t agent, const model::actions::TakeOnState& action) = 0;
    /// At once. False: there is no such light.
    virtual bool tellLight(const model::actions::TellLight& action) = 0;
    /// By the end of this step. False: the scene has no such value.
    virtual bool takeOnFeature(std::uint32_t agent, std::uint32_t feature) = 0;
    [[nodiscard]] virtual bool bears(std::uint32_t agent, std::uint32_t feature) const = 0;
    virtual void noteTags(std::uint32_t agent, std::uint64_t tags) = 0;
};

} // namespace crowd::behavior
