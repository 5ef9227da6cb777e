// SPDX-License-Identifier: MIT
#include "behavior/session/SessionBeginning.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "behavior/session/SceneAdoption.h"
#include "model/population/Properties.h"

namespace crowd::behavior {

namespace {

namespace beginningKeys = model::columns;

constexpr float kFastestWalk = 12.0F; ///< m/s: faster was a jump

/// Where somebody is in a pose; nothing: it does not have him.
std::optional<std::size_t> indexIn(const SessionPose& pose, model::IndividualId id)
{
    const auto found = std::ranges::lower_bound(pose.ids, id);
    if (found == pose.ids.end() || *found != id) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - pose.ids.begin());
}

/// That rules let people play until something else comes.
std::set<std::string> endlessClips(const model::Scene& scene)
{
    std::set<std::string> names;
    for (const model::Rule& rule : scene.rules) {
        for (const model::Action& action : rule.actions) {
            const auto* play = action.as<model::actions::PlayClip>();
            if (play == nullptr || !play->isLooped || play->seconds > 0.0F) {
                continue;
            }
            for (const model::ClipWeight& each : play->clips) {
                names.insert(each.clip);
            }
        }
    }
    return names;
}

/// One beginning: the parts, and the pose.
class Beginning
{
public:
    Beginning(SessionParts& parts, const SessionPose& pose)
        : m_parts(parts), m_pose(pose), m_endless(endlessClips(parts.lastScene))
    {
    }
    void run();

private:
    void recall();
    void putEverybody();
    void put(std::uint32_t agent, std::size_t i);
    [[nodiscard]] bool isEndless(std::uint32_t agent, std::uint16_t clip) const;
    void walkOn(std::uint32_t agent);
    void override();
    void overrideClips();
    template<class T, class Act>
    void forOverridden(model::ColumnKey<T> key, const Act& act) const;
    void overrideOne(const model::PropertyInfo& property, const OverrideColumn& column);
    void dismiss();

    SessionParts& m_parts;
    const SessionPose& m_pose;
    std::set<std::string> m_endless; ///< names of clips
};

void Beginning::run()
{
    recall();
    override();
    putEverybody();
    m_parts.resetBodies(m_parts.population);
    dismiss();
    m_parts.lightCues = m_pose.lightCues;
    m_parts.shownOverrides = m_parts.overrides.publish();
    m_parts.shownNumbers = m_parts.rules.ownNumbers();
}

/// What states have made of them.
void Beginning::recall()
{
    if (!m_pose.recalled) {
        return;
    }
    const model::Population& scene = m_parts.lastScene.population;
    model::Population people = scene;
    writeColumns(*m_pose.recalled, people);
    model::ColumnSet columns;
    for (const model::PropertyInfo& property : model::properties()) {
        if (m_pose.recalled->column(property.id) != nullptr) {
            columns.insert(property.id);
        }
    }
    m_parts.recalled.take(scene, people, columns);
    adoptPeople(m_parts, m_parts.lastScene, people, false);
}

/// What rules have: properties and numbers.
void Beginning::override()
{
    if (m_pose.overrides) {
        for (const model::PropertyInfo& property : model::properties()) {
            if (const OverrideColumn* column = m_pose.overrides->column(property.id)) {
                overrideOne(property, *column);
            }
        }
        overrideClips();
    }
    if (m_pose.numbers) {
        for (const OwnNumber& own : *m_pose.numbers) {
            const std::size_t row = m_parts.population.rowOf(own.id);
            if (row != model::Population::npos) {
                m_parts.rules.setNumber(static_cast<std::uint32_t>(row), own.number, own.value);
            }
        }
    }
}

template<class T, class Act>
void Beginning::forOverridden(model::ColumnKey<T> key, const Act& act) const
{
    const OverrideColumn* column = m_pose.overrides->column(key.id);
    for (std::size_t i = 0; column != nullptr && i < column->ids.size(); ++i) {
        const std::size_t row = m_parts.population.rowOf(column->ids[i]);
        if (row != model::Population::npos) {
            T value;
            std::memcpy(&value, column->bytes.data() + i * sizeof(T), sizeof(T));
            act(static_cast<std::uint32_t>(row), value);
        }
    }
}

void Beginning::overrideOne(const model::PropertyInfo& property, const OverrideColumn& column)
{
    const std::size_t stride = property.column.stride;
    for (std::size_t i = 0; i < column.ids.size(); ++i) {
        if (m_parts.population.rowOf(column.ids[i]) != model::Population::npos) {
            m_parts.overrides.set(property.id, column.ids[i],
                                  std::span(column.bytes).subspan(i * stride, stride));
        }
    }
    if (property.id == beginningKeys::tags.id) {
        forOverridden(beginningKeys::tags, [this](std::uint32_t agent, std::uint64_t tags) {
            m_parts.rules.setTags(agent, tags);
        });
    } else if (property.id == beginningKeys::height.id) {
        forOverridden(beginningKeys::height, [this](std::uint32_t agent, float height) {
            m_parts.agents.height[agent] = height;
        });
    }
}

/// In this order: another clip begins, and another speed has another place at time 0.
void Beginning::overrideClips()
{
    forOverridden(beginningKeys::clip, [this](std::uint32_t agent, std::uint16_t clip) {
        m_parts.idle.resumeClip(agent, clip);
    });
    forOverridden(beginningKeys::playbackSpeed,
                  [this](std::uint32_t agent, float rate) { m_parts.idle.setRate(agent, rate); });
    forOverridden(beginningKeys::phase, [this](std::uint32_t agent, float phase) {
        m_parts.idle.setPhase(agent, phase);
    });
}

void Beginning::putEverybody()
{
    for (std::uint32_t agent = 0; agent < m_parts.agents.size(); ++agent) {
        if (const auto i = indexIn(m_pose, m_parts.population.ids()[agent])) {
            put(agent, *i);
        }
    }
}

void Beginning::put(std::uint32_t agent, std::size_t i)
{
    MotionState& motion = m_parts.agents.motion;
    const ClipPlace shown{m_pose.clips[i], (m_pose.flags[i] & kPoseLooped) != 0, m_pose.rates[i],
                          m_pose.clipSeconds[i], static_cast<double>(m_pose.places[i])};
    const bool isClock = (m_pose.flags[i] & kPoseClock) != 0;
    motion.put(agent, {m_pose.x[i], m_pose.y[i], m_pose.z[i]});
    motion.heading[agent] = m_pose.headings[i];
    if (m_pose.hasSeats) {
        m_parts.seating.resume(agent, m_pose.seats[i]);
    }
    if (isClock && shown.clip != m_parts.idle.clip(agent)) {
        m_parts.idle.setPosture(agent, shown.clip); // it goes with how he sits or stands
    }
    m_parts.animation.resume(agent, shown, isClock, isEndless(agent, shown.clip));
    walkOn(agent);
}

bool Beginning::isEndless(std::uint32_t agent, std::uint16_t clip) const
{
    const model::TemplateEntry* entry = m_parts.templates.entry(m_parts.agents.table[agent]);
    return entry != nullptr && clip < entry->clipNames.size() &&
           m_endless.contains(entry->clipNames[clip]);
}

/// From where he is now.
void Beginning::walkOn(std::uint32_t agent)
{
    PathFollower::Assignment walk = m_parts.walkers.assignmentOf(m_parts.population, agent);
    if (walk.path == 0) {
        return;
    }
    if (m_parts.seating.isSeated(agent)) {
        m_parts.follower.stop(agent);
        return;
    }
    walk.from = m_parts.agents.motion.position(agent);
    m_parts.follower.follow(walk);
}

void Beginning::dismiss()
{
    for (std::uint32_t agent = 0; agent < m_parts.agents.size(); ++agent) {
        const auto i = indexIn(m_pose, m_parts.population.ids()[agent]);
        if (i && (m_pose.flags[*i] & kPoseGone) != 0) {
            m_parts.leave(agent);
        }
    }
}

} // namespace

void beginOnTheMove(SessionParts& parts, const SessionPose& before, const SessionPose& now)
{
    MotionState& motion = parts.agents.motion;
    const auto seconds = static_cast<float>(now.seconds - before.seconds);
    for (std::size_t row = 0; row < parts.population.size(); ++row) {
        const model::IndividualId id = parts.population.ids()[row];
        const auto at = indexIn(now, id);
        const auto from = indexIn(before, id);
        if (!at) {
            continue;
        }
        const std::size_t i = *at;
        motion.heading[row] = now.headings[i];
        if ((now.flags[i] & kPoseLooped) != 0 && (now.flags[i] & kPoseClock) == 0) {
            motion.gaitPlace[row] = now.places[i];
        }
        parts.agents.activate(row);
        if (!from || !(seconds > 0.0F)) {
            continue;
        }
        const std::size_t j = *from;
        const glm::vec2 velocity =
            glm::vec2(now.x[i] - before.x[j], now.z[i] - before.z[j]) / seconds;
        const float speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
        if (speed < kFastestWalk) {
            parts.crowd.bodies()[row].velocityX = velocity.x;
            parts.crowd.bodies()[row].velocityZ = velocity.y;
            motion.speed[row] = speed;
        }
    }
}

void beginAsIn(SessionParts& parts, const SessionPose& pose)
{
    Beginning(parts, pose).run();
}

} // namespace crowd::behavior
