// SPDX-License-Identifier: MIT
#include "behavior/session/SessionRules.h"

#include <algorithm>
#include <cmath>

#include "behavior/rules/PlaceRooms.h"
#include "model/population/PropertyValues.h"

namespace crowd::behavior {

namespace {

constexpr float kMostRate = 100.0F;
constexpr float kLeastWay2 = 1e-4F; ///< m²: nearer points have no direction

} // namespace

glm::vec3 SessionRules::position(std::uint32_t agent) const
{
    return m_parts.agents.motion.position(agent);
}

model::IndividualId SessionRules::id(std::uint32_t agent) const
{
    return m_parts.population.ids()[agent];
}

model::TemplateId SessionRules::templateOf(std::uint32_t agent) const
{
    return m_parts.population.column(model::columns::templateId)[agent];
}

std::uint32_t SessionRules::group(std::uint32_t agent) const
{
    return m_parts.population.column(model::columns::group)[agent];
}

bool SessionRules::isSeated(std::uint32_t agent) const
{
    return m_parts.seating.isSeated(agent);
}

bool SessionRules::isGone(std::uint32_t agent) const
{
    return m_parts.agents.isGone[agent] != 0;
}

model::PathId SessionRules::pathOf(std::uint32_t agent) const
{
    return m_parts.follower.pathOf(agent);
}

std::span<const std::uint8_t> SessionRules::travelEvents() const
{
    return m_parts.follower.travelEvents();
}

model::PlaceId SessionRules::reachedPlace(std::uint32_t agent) const
{
    return m_parts.follower.reachedPlace(agent);
}

float SessionRules::play(std::uint32_t agent, const std::string& clip, bool isLooped)
{
    return m_parts.animation.play(agent, clip, isLooped);
}

void SessionRules::endClip(std::uint32_t agent)
{
    m_parts.animation.endClip(agent);
}

bool SessionRules::follow(std::uint32_t agent, model::PathId path)
{
    if (!m_parts.follower.hasPath(path)) {
        return false;
    }
    leaveSeat(agent);
    PathFollower::Assignment walk = m_parts.walkers.assignmentOf(m_parts.population, agent);
    walk.path = path;
    walk.from = position(agent);
    walk.metresPerSecond = m_parts.follower.pace(agent);
    return m_parts.follower.follow(walk);
}

glm::vec3 SessionRules::reached(const glm::vec3& from, const glm::vec3& point) const
{
    return m_parts.surface ? m_parts.surface->straight(from, point).value_or(point) : point;
}

float SessionRules::wayMetres(const glm::vec3& from, const glm::vec3& to, float within) const
{
    const auto metres =
        m_parts.surface ? m_parts.surface->wayMetres(from, to, within) : std::nullopt;
    return metres.value_or(flatDistance(from, to)); // also where it is off the surface
}

void SessionRules::sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast)
{
    leaveSeat(agent);
    m_parts.follower.sendTo(agent, point, std::min(atLeast, model::kMaxWalkingSpeed));
}

void SessionRules::stop(std::uint32_t agent)
{
    m_parts.follower.stop(agent);
}

void SessionRules::goOn(std::uint32_t agent)
{
    if (pathOf(agent) != 0) {
        leaveSeat(agent);
    }
    m_parts.follower.goOn(agent);
}

void SessionRules::setPace(std::uint32_t agent, float metresPerSecond)
{
    if (std::isfinite(metresPerSecond)) {
        m_parts.follower.setPace(agent, std::clamp(metresPerSecond, 0.0F, model::kMaxWalkingSpeed));
    }
}

void SessionRules::turnTo(std::uint32_t agent, const glm::vec3& point)
{
    const glm::vec3 way = point - position(agent);
    if (way.x * way.x + way.z * way.z > kLeastWay2) {
        m_parts.agents.turnTo(agent, std::atan2(way.x, way.z));
    }
}

float SessionRules::speed(std::uint32_t agent) const
{
    return m_parts.agents.motion.speed[agent];
}

glm::vec2 SessionRules::wantedVelocity(std::uint32_t agent) const
{
    const Body& body = m_parts.crowd.bodies()[agent];
    return body.preferredSpeed > 0.0F ? glm::vec2(body.desiredX, body.desiredZ) : glm::vec2(0.0F);
}

void SessionRules::appear(std::uint32_t agent, const glm::vec3& point)
{
    leaveSeat(agent);
    AgentColumns& agents = m_parts.agents;
    agents.activate(agent);
    agents.isGone[agent] = 0;
    agents.isPut[agent] = 1;
    agents.motion.speed[agent] = 0.0F;
    agents.motion.put(agent, point);
    if (m_parts.surface) {
        agents.motion.y[agent] = m_parts.surface->height(point.x, point.z, point.y);
    }
    m_parts.animation.cut(agent);
    m_parts.animation.stand(agent);
    m_parts.follower.stop(agent);
    m_parts.follower.forgetWay(agent);
}

bool SessionRules::sit(std::uint32_t agent, float metres)
{
    return m_parts.seating.sit(agent, metres);
}

bool SessionRules::isSittingDown(std::uint32_t agent) const
{
    return m_parts.agents.isOnWayToSeat(agent);
}

float SessionRules::property(std::uint32_t agent, model::ComparedProperty property) const
{
    switch (property) {
    case model::ComparedProperty::Height:
        return m_parts.agents.height[agent];
    case model::ComparedProperty::Girth:
        return m_parts.population.column(model::columns::girth)[agent];
    case model::ComparedProperty::PlaybackSpeed:
        return m_parts.idle.rate(agent);
    case model::ComparedProperty::WalkSpeed:
        return m_parts.follower.pace(agent);
    case model::ComparedProperty::Clip:
        break;
    }
    return 0.0F;
}

bool SessionRules::showsClip(std::uint32_t agent, const std::string& clip) const
{
    const int named = m_parts.templates.clipNamed(m_parts.agents.table[agent], clip);
    return named >= 0 && static_cast<int>(m_parts.animation.shown(agent).clip.clip) == named;
}

void SessionRules::setTint(std::uint32_t agent, const model::actions::SetProperty& action)
{
    const model::TemplateEntry* entry = m_parts.templates.entry(m_parts.agents.table[agent]);
    const std::size_t count =
        entry != nullptr && entry->asset
            ? std::min<std::size_t>(entry->asset->slots.size(), model::kMaxTintSlots)
            : 0;
    for (std::size_t slot = 0; slot < count; ++slot) {
        const model::Slot& each = entry->asset->slots[slot];
        if (action.slot.empty() ? each.tintable : each.name == action.slot) {
            m_parts.overrides.set(model::columns::tint(static_cast<int>(slot)), id(agent),
                                  action.tint());
        }
    }
}

void SessionRules::setProperty(std::uint32_t agent, const model::actions::SetProperty& action,
                               const std::string& clip)
{
    AgentColumns& agents = m_parts.agents;
    agents.markDirty(agent);
    switch (action.property) {
    case model::SettableProperty::Tint:
        setTint(agent, action);
        return;
    case model::SettableProperty::Height:
        agents.height[agent] =
            model::nearestLegal(model::propertyInfo(model::ColumnId::Height), action.value);
        m_parts.overrides.set(model::columns::height, id(agent), agents.height[agent]);
        return;
    case model::SettableProperty::PlaybackSpeed:
        agents.activate(agent);
        m_parts.idle.setRate(agent, std::clamp(action.value, 0.0F, kMostRate));
        return;
    case model::SettableProperty::Clip:
        agents.activate(agent);
        m_parts.idle.setClip(agent, clip);
        return;
    case model::SettableProperty::Phase:
        agents.activate(agent);
        m_parts.idle.setPlace(agent, static_cast<double>(std::clamp(action.value, 0.0F, 1.0F)));
        return;
    }
}

bool SessionRules::takeOnState(std::uint32_t agent, const model::actions::TakeOnState& action)
{
    const auto& states = m_parts.lastScene.states;
    if (std::ranges::find(states, action.state, &model::State::id) == states.end()) {
        return false;
    }
    m_parts.ruleRecalls.push_back({id(agent), action});
    return true;
}

bool SessionRules::tellLight(const model::actions::TellLight& action)
{
    const model::Light* light = model::findLight(m_parts.lastScene.lights, action.light);
    if (light == nullptr) {
        return false;
    }
    model::LightCues cues = m_parts.lightCues ? *m_parts.lightCues : model::LightCues();
    model::tellLight(cues, *light, action.deed, action.seconds, m_parts.clock.seconds());
    if (!m_parts.lightCues || cues != *m_parts.lightCues) {
        m_parts.lightCues = std::make_shared<const model::LightCues>(std::move(cues));
    }
    return true;
}

bool SessionRules::takeOnFeature(std::uint32_t agent, std::uint32_t feature)
{
    constexpr std::uint32_t kMost = 0xFFFF;
    const auto wanted = static_cast<model::FeatureId>(feature <= kMost ? feature : 0);
    if (model::findFeature(m_parts.lastScene.features, wanted) == nullptr) {
        return false;
    }
    m_parts.ruleFeatures.push_back({id(agent), wanted});
    return true;
}

bool SessionRules::bears(std::uint32_t agent, std::uint32_t feature) const
{
    for (std::uint8_t kind = 1; kind <= model::kMostFeatureKinds; ++kind) {
        const auto borne = m_parts.population.column(model::columns::feature(kind));
        if (feature != 0 && borne[agent] == feature) {
            return true;
        }
    }
    return false;
}

void SessionRules::noteTags(std::uint32_t agent, std::uint64_t tags)
{
    m_parts.overrides.set(model::columns::tags, id(agent), tags);
}

} // namespace crowd::behavior
