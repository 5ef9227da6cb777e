// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include "model/scene/Path.h"

namespace crowd::behavior {

/// How many people of a session are where, as of one of its steps; who has left the scene counts
/// nowhere. Ids with nobody are left out.
struct SessionTally
{
    std::map<model::PathId, std::uint32_t> followers; ///< on their way along a path
    std::map<model::PlaceId, std::uint32_t> inside;   ///< within a place's circle
    friend bool operator==(const SessionTally&, const SessionTally&) = default;
};

} // namespace crowd::behavior
