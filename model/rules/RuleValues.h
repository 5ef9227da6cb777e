// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/scene/Path.h"

/// Small values that the parts of rules are made of. Metres, seconds.
namespace crowd::model {

using RuleId = std::uint32_t;
/// Stable name of an artist's number within a scene; 0 is none.
using NumberId = std::uint32_t;

/// A place or a path that is still to be chosen, where 0 means any.
inline constexpr std::uint32_t kNotChosen = 0xFFFFFFFFU;

inline constexpr int kTagCount = 64; ///< bits of the tags column
inline constexpr float kMaxNumber = 1e6F;
inline constexpr std::uint32_t kMaxTimes = 1000; ///< that an action repeats
inline constexpr float kMaxSeconds = 86400.0F;
inline constexpr float kMaxRuleMetres = 10000.0F;

enum class Comparison : std::uint8_t { Less, Equal, More };

/// Whom or what an action is about.
enum class ActionAim : std::uint8_t {
    Sender, ///< who sent the event or came near; where it came from when nobody did
    Tagged, ///< the nearest one with the tag
    Place,
    Related ///< the nearest one to whom he is related, whichever way
};

struct AimChoice
{
    ActionAim aim = ActionAim::Sender;
    std::uint8_t tag = 0;       ///< Tagged
    PlaceId place = 0;          ///< Place
    std::uint32_t relation = 0; ///< Related: RelationKindId, 0: any
    friend bool operator==(const AimChoice&, const AimChoice&) = default;
};

/// Which place to go to, or to leave at. Candidates of all but Given: the path's places where one
/// is given, else all that are called as the given place, else all spots; all exits to leave at.
/// Who waits for a free one gets it in his turn: first come, first served.
enum class PlaceChoice : std::uint8_t {
    Given,
    Nearest,
    NearestFree,
    FirstFree, ///< in the path's order; behind the last who has one where people move up
    Ahead      ///< the one before his in the path's order, once it is free: queues move up
};

struct WantedPlace
{
    PlaceChoice choice = PlaceChoice::Given;
    PlaceId place = 0; ///< Given, or one of the name that is meant
    PathId path = 0;   ///< all but Given
    friend bool operator==(const WantedPlace&, const WantedPlace&) = default;
};

} // namespace crowd::model
