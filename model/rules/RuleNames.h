// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/population/Columns.h"
#include "model/rules/RuleValues.h"
#include "model/states/RecallTiming.h"

/// What rules speak of by name, and what speaks to them.
namespace crowd::model {

using CueId = std::uint32_t;

/// A tag as the artist knows it.
struct TagName
{
    std::uint8_t bit = 0; ///< 0..63
    std::string name;
    std::array<std::uint8_t, 3> color{200, 80, 200}; ///< sRGB
    std::string unknownMembers{};                    ///< see Scene::unknownMembers
    friend bool operator==(const TagName&, const TagName&) = default;
};

/// A number that everybody has, as the artist knows it; rules ask for it and change it while a
/// session runs. Everybody begins with one of his own between low and high.
struct NumberName
{
    NumberId id = 0;
    std::string name;
    float low = 0.0F;
    float high = 0.0F;
    /// Who begins with another one: what a session had made of it when the pose was kept. Ascending
    /// ids; they may name who is gone.
    std::vector<std::pair<IndividualId, float>> values{};
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const NumberName&, const NumberName&) = default;
};
/// Numbers, and cues, that a scene may have.
inline constexpr std::size_t kMaxNamed = 256;

/// Keys that a cue may have: those that no tool or camera has.
inline constexpr std::array<std::string_view, 8> kCueKeys{"F3", "F4", "F5", "F6",
                                                          "F7", "F8", "F9", "F10"};

/// Whom a cue speaks to.
enum class CueReach : std::uint8_t { Everybody, Selected, Tagged };

/// A button, and a key where one is given, that send an event to a running session, or let people
/// take on a state in it, or both.
struct Cue
{
    CueId id = 0;
    std::string name;
    std::string event; ///< empty: none
    float payload = 0.0F;
    std::string key; ///< "F3" to "F10"; empty: none
    CueReach reach = CueReach::Everybody;
    std::uint8_t tag = 0; ///< Tagged
    // Of the state that they take on.
    std::uint32_t state = 0; ///< StateId; 0: none
    float seconds = 0.0F;    ///< that each takes
    float spread = 0.0F;     ///< seconds from the first who begins to the last
    StaggerOrder order = StaggerOrder::Distance;
    glm::vec3 point{0.0F};        ///< of Distance, metres
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const Cue&, const Cue&) = default;
};

} // namespace crowd::model
