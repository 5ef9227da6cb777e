// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "model/base/Values.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Stable name of a group within its scene, as the column "group" has it; 0 is none.
using GroupId = std::uint32_t;

/// A layer of the crowd: a name for those whose column "group" has its id. People may also have
/// numbers that no group is there for; these are seen and can be changed.
struct Group
{
    GroupId id = 0;
    std::string name;
    PaintColor color{90, 150, 220}; ///< sRGB
    bool isHidden = false;          ///< neither drawn nor touched
    bool isLocked = false;          ///< drawn, but no stroke, move or selection touches them
    /// Walk as one party: all take the same branch of a path. Numbers without a group do.
    bool isParty = false;
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const Group&, const Group&) = default;
};

constexpr auto Group::fields()
{
    return std::tuple(
        field(&Group::id, {.key = "id",
                           .doc = "what the column \"group\" has",
                           .low = 1.0,
                           .high = std::numeric_limits<std::uint32_t>::max()}),
        field(&Group::name, {.key = "name", .label = QT_TRANSLATE_NOOP("Fields", "Name")}),
        field(&Group::color, {.key = "color", .label = QT_TRANSLATE_NOOP("Fields", "Colour")}),
        field(&Group::isHidden, {.key = "hidden",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Hidden"),
                                 .doc = "neither drawn nor touched"}),
        field(&Group::isLocked, {.key = "locked",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Locked"),
                                 .doc = "no stroke touches them"}),
        field(&Group::isParty,
              {.key = "party",
               .label = QT_TRANSLATE_NOOP("Fields", "Walk as one party"),
               .tip = QT_TRANSLATE_NOOP("Fields", "All of them take the same branch of a path"),
               .doc = "all take the same branch of a path"}));
}

/// Ids of those groups of which `member` holds, ascending.
[[nodiscard]] inline std::vector<GroupId> groupsThat(std::span<const Group> groups,
                                                     bool Group::*member)
{
    std::vector<GroupId> ids;
    for (const Group& group : groups) {
        if (group.*member) {
            ids.push_back(group.id);
        }
    }
    return ids;
}

/// Whether a group is among those; ascending.
[[nodiscard]] inline bool isAmong(std::span<const GroupId> groups, GroupId group)
{
    return std::ranges::binary_search(groups, group);
}

} // namespace crowd::model
