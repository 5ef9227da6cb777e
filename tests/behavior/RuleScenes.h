// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tests/behavior/Actors.h"

/// Scenes for rules to work in: rows of seats and lines of places; and what the rules leave behind.
namespace crowd::testing {

inline Action tagWith(std::uint8_t tag)
{
    actions::AddTag made;
    made.tag = tag;
    return made;
}

inline Action sitDown()
{
    actions::SitDown made;
    made.metres = 0.0F; // however far
    return made;
}

inline Rule when(model::Trigger trigger, std::vector<Action> actions, model::RuleId id = 1)
{
    Rule rule;
    rule.id = id;
    rule.name = "when";
    rule.trigger = std::move(trigger);
    rule.actions = std::move(actions);
    return rule;
}

inline bool hasTag(Session& session, std::uint32_t agent, std::uint8_t tag)
{
    return (session.rules().tags(agent) >> tag & 1U) != 0;
}

/// Four seats in a row at z = 6, 0.6 m apart, each 0.45 m high and facing -Z.
inline void addSeats(model::Scene& scene, int count = 4)
{
    auto asset = std::make_shared<model::StageAsset>();
    for (int i = 0; i < count; ++i) {
        model::Seat seat;
        seat.position = {0.6F * static_cast<float>(i), 0.0F, 6.0F};
        seat.headingRadians = 3.14159265F;
        seat.height = 0.45F;
        asset->seats.push_back(seat);
    }
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = asset;
    scene.stages.push_back(entry);
}

inline model::SeatId shownSeat(const Session& session, std::size_t row)
{
    return session.frame()->population.column(model::columns::seat)[row];
}

/// Places 1.5 m apart along Z from z = 4, and a path "line" over them, the nearest in front.
inline void addLine(model::Scene& scene, int places)
{
    model::Path line{1, "line", model::PathKind::Simple, {}};
    for (int i = 0; i < places; ++i) {
        const auto id = static_cast<model::PlaceId>(i + 1);
        scene.places.push_back(
            {id, "spot", {0.0F, 0.0F, 4.0F + 1.5F * static_cast<float>(i)}, 0.2F});
        line.places.push_back(id);
    }
    scene.paths.push_back(line);
}

inline void letWalk(model::Scene& scene, model::PathId path)
{
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    const std::vector<model::PathId> paths(all.size(), path);
    scene.population.setValues<model::PathId>(model::columns::path, all, paths);
}

} // namespace crowd::testing
