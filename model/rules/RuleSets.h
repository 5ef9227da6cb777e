// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/Scene.h"

/// Rules to begin with, made for the clips and places of a scene.
namespace crowd::model {

enum class RuleSet : std::uint8_t {
    Audience,    ///< applause and cheers that spread from where they began
    StadiumWave, ///< a wave that runs round
    Pedestrians, ///< some stop, look and go on; events make them run, walk or stop
    Panic,       ///< away from it, on to others, out at the exits
    Flock,       ///< animals that wander, and run when startled
    Queue,       ///< people line up on the places of a path, move up and are served at its first
    Count
};

/// As scripts call them, in the order of RuleSet.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(RuleSet::Count)>
    kRuleSetKeys{"audience", "stadium wave", "pedestrians", "panic", "flock", "queue"};

/// Without ids: they are given when the rules are added. Empty names stay for what a scene has not.
[[nodiscard]] std::vector<Rule> rulesOf(RuleSet set, const Scene& scene);
/// What the scene's rules listen to, each once, in their order.
[[nodiscard]] std::vector<std::string> eventsOf(const Scene& scene);
/// The scene's cues and one each for what the rules of the set listen to and no cue sends yet, as
/// many as a scene may have.
[[nodiscard]] std::vector<Cue> cuesWith(RuleSet set, const std::vector<Rule>& rules,
                                        const Scene& scene);
/// A cue to add: for the first event of the rules that none sends, with a key that none has.
[[nodiscard]] Cue nextCue(const Scene& scene);
/// Gives ids that no rule of the scene has.
void giveIds(std::vector<Rule>& rules, const Scene& scene);

} // namespace crowd::model
