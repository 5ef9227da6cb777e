// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "model/base/Message.h"
#include "model/describe/Field.h"
#include "model/scene/HandEdit.h"
#include "model/scene/MotionFile.h"
#include "model/scene/Timeline.h"

/// Runs of a scene that were kept. Plain values, part of the scene.
namespace crowd::model {

/// A stable name within a scene; 0: none.
using TakeId = std::uint32_t;

/// Each has a file open.
inline constexpr std::size_t kMostTakes = 200;

/// How everybody moved in a run, to be shown again whatever has become of paths and rules since.
/// The motion is in a file of its own, which is called after what is in it and never changes; see
/// TakeFiles.h for where it lies.
struct Take
{
    TakeId id = 0;
    std::string name;
    std::string file;   ///< its name, without a folder
    double begin = 0.0; ///< seconds of the clock, of its first step
    double end = 0.0;   ///< and of its last
    int people = 0;     ///< that it moves
    /// It is what is seen instead of a run; of one take at most (see shownTake()).
    bool isShown = false;
    /// What is done to people of it by hand, in this order.
    std::vector<HandEdit> edits{};
    bool areEditsOn = true;       ///< all of them
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    MotionFilePtr motion{};       ///< null: not there, or not loaded yet
    Message problem{};            ///< why it is not there; empty otherwise

    static constexpr auto fields();
    friend bool operator==(const Take&, const Take&) = default;
};

/// Ascending ids.
using Takes = std::vector<Take>;

/// Null: there is none.
[[nodiscard]] inline const Take* findTake(const Takes& takes, TakeId id)
{
    const auto found = std::ranges::find(takes, id, &Take::id);
    return found == takes.end() ? nullptr : &*found;
}
/// The first that is to be shown, also where its motion is not there; null: none.
[[nodiscard]] inline const Take* shownTake(const Takes& takes)
{
    const auto found = std::ranges::find(takes, true, &Take::isShown);
    return found == takes.end() ? nullptr : &*found;
}
/// For one more: above all that there are; 0: there is no room.
[[nodiscard]] inline TakeId freeTakeId(const Takes& takes)
{
    const TakeId last = takes.empty() ? 0 : takes.back().id;
    return takes.size() >= kMostTakes ? 0 : last + 1; // 0 as well after the highest
}

constexpr auto Take::fields()
{
    return std::tuple(
        field(&Take::id, {.key = "id",
                          .doc = "of no other take of the scene",
                          .low = 1.0,
                          .high = 4294967295.0}),
        field(&Take::name, {.key = "name",
                            .label = QT_TRANSLATE_NOOP("Fields", "Name"),
                            .doc = "as the editor shows it"}),
        field(&Take::file, {.key = "file",
                            .doc = "name of the file with its motion, in the folder of takes "
                                   "beside the project"}),
        field(&Take::begin, {.key = "begin",
                             .doc = "seconds of the clock at which it begins",
                             .low = -kLatestMark,
                             .high = kLatestMark}),
        field(&Take::end, {.key = "end",
                           .doc = "seconds of the clock at which it ends",
                           .low = -kLatestMark,
                           .high = kLatestMark}),
        field(&Take::people, {.key = "people", .doc = "how many it moves", .high = 2147483647.0}),
        field(&Take::isShown, {.key = "shown", .doc = "whether it is seen instead of a run"}),
        field(&Take::edits,
              {.key = "edits", .doc = "what is done to people of it by hand, in this order"}),
        field(&Take::areEditsOn, {.key = "edited", .doc = "whether its edits count"}));
}

} // namespace crowd::model
