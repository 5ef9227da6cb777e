// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "behavior/session/Session.h"

/// People with clips to stand, walk, run, clap and sit with, for tests of sessions.
namespace crowd::testing {

namespace actions = model::actions;
namespace conditions = model::conditions;
namespace triggers = model::triggers;
using behavior::Session;
using model::Action;
using model::Rule;

inline model::TemplateEntry actorTemplate()
{
    auto asset = std::make_shared<model::Template>();
    const auto clip = [&asset](const char* name, float seconds, float speed, bool isLooped) {
        model::Clip made;
        made.name = name;
        made.seconds = seconds;
        made.speed = speed;
        made.role = speed <= 0.0F  ? model::ClipRole::Other
                    : speed > 2.0F ? model::ClipRole::Run
                                   : model::ClipRole::Walk;
        made.loop = isLooped;
        asset->clips.push_back(made);
    };
    clip("idle", 2.0F, 0.0F, true);
    clip("walk", 1.0F, 1.3F, true);
    clip("run", 0.7F, 3.0F, true);
    clip("clap", 1.5F, 0.0F, false);
    clip("sit", 2.0F, 0.0F, true);
    clip("sit_down", 1.0F, 0.0F, false);
    clip("stand_up", 1.0F, 0.0F, false);
    clip("stroll", 1.2F, 0.8F, true);
    asset->defaultClip = 0;
    asset->seatedClip = 4;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.name = "actor";
    entry.asset = asset;
    entry.clipNames = {"idle", "walk", "run", "clap", "sit", "sit_down", "stand_up", "stroll"};
    entry.clipSpeeds.assign(8, std::numeric_limits<float>::quiet_NaN());
    return entry;
}

/// So many people in a row, two metres apart.
inline model::Scene rowOf(std::size_t people)
{
    model::Scene scene;
    scene.templates.push_back(actorTemplate());
    std::vector<model::IndividualId> ids(people);
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < people; ++i) {
        rows.column(model::columns::templateId)[i] = 1;
        rows.column(model::columns::position)[i] = {2.0F * static_cast<float>(i), 0.0F, 0.0F};
    }
    scene.population.add(rows);
    return scene;
}

inline Rule onEvent(const char* event, std::vector<Action> actions)
{
    Rule rule;
    rule.id = 1;
    rule.name = event;
    rule.trigger = triggers::Event{event};
    rule.actions = std::move(actions);
    return rule;
}

inline Action tellNear(const char* event, float metres, float secondsPerMetre = 0.0F)
{
    actions::SendEvent made;
    made.event = event;
    made.reach = model::EventReach::Near;
    made.metres = metres;
    made.secondsPerMetre = secondsPerMetre;
    return made;
}

inline std::uint16_t clipOf(const Session& session, std::size_t row)
{
    return session.frame()->population.column(model::columns::clip)[row];
}

inline glm::vec3 placeOf(const Session& session, std::size_t row)
{
    return session.frame()->population.column(model::columns::position)[row];
}

inline void run(Session& session, int steps)
{
    for (int i = 0; i < steps; ++i) {
        session.step();
    }
}

} // namespace crowd::testing
