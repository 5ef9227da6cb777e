// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <QtCore/QString>

#include "behavior/session/MotionCache.h"
#include "behavior/surface/WalkSurface.h"
#include "behavior/takes/TakeFile.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "model/scene/Take.h"

namespace crowd::behavior {

/// Who of a take is asked to do something again, and when.
struct RetakeOrder
{
    std::vector<model::IndividualId> people; ///< ascending
    double begin = 0.0;                      ///< seconds of the clock
    double end = 0.0;
    bool isDifferent = false; ///< dice fall otherwise than in the run
};

/// A retake as a file.
struct KeptRetake
{
    model::Take take; ///< without a name and an id; hand edits survive in it
    std::size_t people = 0;
    float furthestFromHome = 0.0F; ///< see Retaken
};

/// Takes some people of a take again, see retake(), and writes what comes of it into a folder of
/// takes. `surface`: null: it is found. Any thread; can be given up.
[[nodiscard]] model::Result<KeptRetake>
keepRetake(const model::Scene& scene, const model::Take& take,
           const std::shared_ptr<MotionCache>& motion, const RetakeOrder& order,
           const std::shared_ptr<const WalkSurface>& surface, const QString& folder,
           const TakeProgress& progress = {});

} // namespace crowd::behavior
