// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace crowd::model {

/// Stable names within a scene; 0 is none.
using PlaceId = std::uint32_t;
using PathId = std::uint32_t;

/// A spot with a size on the ground. World frame, metres.
struct Place
{
    PlaceId id = 0;
    std::string name;
    glm::vec3 position{0.0F};
    float radius = 1.0F;
    friend bool operator==(const Place&, const Place&) = default;
};

/// What happens at the last place: stop; go on to the first; jump to the first.
enum class PathKind : std::uint8_t { Simple, Cyclic, Teleport };

/// An ordered list of places to walk along.
struct Path
{
    PathId id = 0;
    std::string name;
    PathKind kind = PathKind::Simple;
    std::vector<PlaceId> places;
    friend bool operator==(const Path&, const Path&) = default;
};

} // namespace crowd::model
