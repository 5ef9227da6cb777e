// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace crowd::behavior {

/// What happened to an agent on its way during one step; bits.
enum TravelEvent : std::uint8_t {
    kReachedPlace = 1, ///< a stop of the path that it follows
    kEndedPath = 2,    ///< the last stop of a path that has an end
    kEndedErrand = 4   ///< the point that it was sent to, or as near to it as it can get
};

} // namespace crowd::behavior
