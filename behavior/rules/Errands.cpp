// SPDX-License-Identifier: MIT
#include "behavior/rules/Errands.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>

#include "behavior/motion/TravelEvents.h"
#include "model/base/Bounds.h"
#include "model/base/Random.h"
#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr float kFullTurn = 6.2831853F;
constexpr float kThereMetres = 1.5F;             ///< beside a place
constexpr double kSecondsToAskAgain = 1.0 / 3.0; ///< for a free place

bool isForFree(const PlaceWish& wish)
{
    return wish.choice == model::PlaceChoice::NearestFree ||
           wish.choice == model::PlaceChoice::FirstFree;
}

void reportNowhere(const ActionScope& scope, const PlaceWish& wish)
{
    if (wish.choice == model::PlaceChoice::Given) {
        scope.report(QT_TRANSLATE_NOOP("Messages", "Rule \"%1\" sends characters to a place that "
                                                   "is not there any more. Choose another one."));
    } else if (wish.path != 0) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" sends characters to places of a path that is not there any more, or has "
            "none. Choose another one."));
    } else if (wish.place != 0) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" sends characters to places by a name that none has any more. Choose "
            "another one."));
    } else if (wish.role == model::PlaceRole::Exit) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" lets characters leave at an exit, but there is none: they stay. "
            "Paint one with the environment brush."));
    } else {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" sends characters to a place, but there is none. Paint one with "
            "the path brush."));
    }
}

/// Until one is free he goes on with what he does.
void waitForPlace(const ActionScope& scope, const PlaceWish& wish)
{
    ActionProgress& progress = scope.progress();
    progress.isStarted = true;
    progress.until = scope.now() + kSecondsToAskAgain;
    if (progress.ticket == 0) {
        progress.ticket = scope.state.turns.append(scope.state.agents.ids()[scope.agent], wish);
    }
}

/// The nearest one is that with the shortest way. Nothing: there is none now, or others wait for
/// one already.
std::optional<model::PlaceId> choosePlace(const ActionScope& scope, const PlaceWish& wish)
{
    RuleState& state = scope.state;
    if (isForFree(wish) || wish.choice == model::PlaceChoice::Ahead) {
        (void)countedPlaces(scope);
    }
    const model::PlaceId held = scope.self().heldPlace;
    const bool mayChoose = !isForFree(wish) || state.places.isAmong(wish, held) ||
                           state.turns.isFirst(state.agents, scope.agent, wish);
    if (!mayChoose) {
        return std::nullopt;
    }
    const glm::vec3 at = scope.host.position(scope.agent);
    const auto wayTo = [&](const model::Place& to) {
        return scope.host.wayMetres(at, to.position, to.radius + kThereMetres);
    };
    return state.places.choose(wish, at, held, wayTo);
}

void goToPlace(const ActionScope& scope, model::PlaceId place)
{
    scope.self().errand.goal = place;
    scope.progress().until = scope.now() + kSecondsToAskAgain;
    holdPlace(scope.state, scope.agent, place);
    sendTo(scope, pointIn(scope, *scope.state.places.find(place)), 0.0F);
}

ActionStatus setOut(const ActionScope& scope, const PlaceWish& wish)
{
    if (!scope.state.places.hasAny(wish)) {
        reportNowhere(scope, wish);
    }
    const std::optional<model::PlaceId> place = choosePlace(scope, wish);
    if (place) {
        scope.progress().isStarted = true;
        scope.progress().isTravelling = true;
        scope.progress().ticket = 0;
        goToPlace(scope, *place);
        return ActionStatus::Running;
    }
    if (isForFree(wish)) {
        waitForPlace(scope, wish);
        return ActionStatus::Running;
    }
    return ActionStatus::Done;
}

/// On his way to the end of a line he goes further up as that gets shorter, so that those behind
/// him can set out too.
void moveUp(const ActionScope& scope, PlaceWish wish)
{
    scope.progress().until = scope.now() + kSecondsToAskAgain;
    if (!scope.state.places.isLine(wish)) {
        return;
    }
    wish.choice = model::PlaceChoice::Ahead;
    const std::optional<model::PlaceId> place =
        countedPlaces(scope).choose(wish, scope.host.position(scope.agent), scope.self().heldPlace);
    if (place) {
        goToPlace(scope, *place);
    }
}

} // namespace

void sendTo(const ActionScope& scope, const glm::vec3& point, float atLeast)
{
    scope.self().errand.startedInStep = scope.state.clock.step;
    scope.host.sendTo(scope.agent, point, atLeast);
}

void sendAway(const ActionScope& scope, const glm::vec3& point)
{
    scope.self().errand.goal = 0;
    holdPlace(scope.state, scope.agent, 0);
    sendTo(scope, point, 0.0F);
}

bool hasErrandEnded(const RuleScope& scope, std::uint32_t agent)
{
    return (scope.host.travelEvents()[agent] & kEndedErrand) != 0 &&
           scope.state.agents[agent].errand.startedInStep != scope.state.clock.step;
}

namespace {

/// Somewhere along a line or in an area; of a round place its middle.
glm::vec3 middleFor(const ActionScope& scope, const model::Place& place)
{
    constexpr int kTries = 16;
    const auto share = [&](std::uint64_t key) {
        return draw(scope, scope.agent, model::hashKeys(place.id, key));
    };
    const std::vector<glm::vec3>& corners = place.corners;
    if (place.shape == model::PlaceShape::Line && corners.size() > 1) {
        const float along = share(84) * static_cast<float>(corners.size() - 1);
        const auto side = std::min(static_cast<std::size_t>(along), corners.size() - 2);
        return place.position +
               glm::mix(corners[side], corners[side + 1], along - static_cast<float>(side));
    }
    model::Bounds bounds;
    for (const glm::vec3& corner : corners) {
        bounds.add(corner);
    }
    for (int i = 0; i < kTries && place.shape == model::PlaceShape::Area; ++i) {
        const std::uint64_t key = 85 + 2 * static_cast<std::uint64_t>(i);
        const glm::vec3 at =
            glm::mix(bounds.low, bounds.high, glm::vec3(share(key), 0.5F, share(key + 1)));
        if (model::isEnclosed(corners, {at.x, at.z})) {
            return place.position + at;
        }
    }
    return place.position;
}

} // namespace

glm::vec3 pointIn(const ActionScope& scope, const model::Place& place)
{
    const float radius =
        place.radius * std::sqrt(draw(scope, scope.agent, model::hashKeys(place.id, 82)));
    const float angle = kFullTurn * draw(scope, scope.agent, model::hashKeys(place.id, 83));
    const glm::vec3 aside = radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
    return scope.host.reached(place.position, middleFor(scope, place) + aside);
}

ActionStatus travel(const ActionScope& scope, const PlaceWish& wish)
{
    ActionProgress& progress = scope.progress();
    if (scope.host.isGone(scope.agent)) {
        return ActionStatus::Done;
    }
    const model::PlaceId goal = scope.self().errand.goal;
    if (progress.isTravelling && goal != 0 && scope.state.places.find(goal) == nullptr) {
        progress = {}; // somebody has taken it away: to another one, if there is any
        scope.host.stop(scope.agent);
    }
    if (progress.isTravelling) {
        if (hasErrandEnded(scope, scope.agent)) {
            return ActionStatus::Done;
        }
        if (wish.choice == model::PlaceChoice::FirstFree && scope.now() >= progress.until) {
            moveUp(scope, wish);
        }
        return ActionStatus::Running;
    }
    const bool asksAgain = !progress.isStarted || scope.now() >= progress.until;
    return asksAgain ? setOut(scope, wish) : ActionStatus::Running;
}

bool isAtGoal(const ActionScope& scope, float ahead)
{
    const model::Place* place =
        scope.progress().isTravelling ? scope.state.places.find(scope.self().errand.goal) : nullptr;
    return place != nullptr && flatDistance(place->position, scope.host.position(scope.agent)) <=
                                   place->radius + kThereMetres + ahead;
}

} // namespace crowd::behavior
