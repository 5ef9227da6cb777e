// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "behavior/session/MotionCache.h"
#include "behavior/surface/WalkSurface.h"
#include "behavior/takes/TakeFile.h"
#include "model/base/Result.h"
#include "model/scene/HandEdit.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// Who of a take does something again, and when.
struct RetakeWish
{
    std::vector<model::IndividualId> people; ///< ascending
    double begin = 0.0;                      ///< seconds of the clock
    double end = 0.0;                        ///< before the take's end they come back by then
    std::uint32_t seed = 0;                  ///< 0: the scene's; another one is another run
    /// Of the take: others are avoided where these bring them.
    std::vector<model::HandEdit> edits{};
};

/// What came of it.
struct Retaken
{
    std::shared_ptr<MotionCache> motion; ///< all of the take's steps
    std::size_t people = 0;              ///< that were taken again
    std::uint64_t steps = 0;             ///< that they made
    /// Metres that somebody was from where he had to be at the end, before he was brought there.
    float furthestFromHome = 0.0F;
};

/// Some people of a take are simulated again, from where they were in it, by the scene as it is
/// now; everybody else does what he did, and they make way for him. They go on from the pace that
/// they had; towards the end of a stretch that is followed by more of the take they walk to where
/// they were, and what is left of the way is blended. Rules and timers begin anew with the stretch;
/// of others they know nothing. `surface`: null: open ground. Any thread; can be given up.
[[nodiscard]] model::Result<Retaken>
retake(const model::Scene& scene, const std::shared_ptr<MotionCache>& take, const RetakeWish& wish,
       const std::shared_ptr<const WalkSurface>& surface, const TakeProgress& progress = {});

} // namespace crowd::behavior
