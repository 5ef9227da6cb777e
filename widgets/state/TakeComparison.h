// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "model/base/Result.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "model/scene/Take.h"

namespace crowd::widgets {

/// How two takes of the same people differ over all the time that both have.
struct TakeComparison
{
    std::size_t people = 0;    ///< that were compared
    std::size_t elsewhere = 0; ///< of whom so many were elsewhere at some time
    std::size_t missing = 0;   ///< and so many were there in one of them only
    double apartFrom = 0.0;    ///< seconds of the clock at which the first one is
    float most = 0.0F;         ///< metres between somebody and himself
    double mostAt = 0.0;       ///< and when
};

/// As they are seen, with what is done to their people by hand; of long ones some moments alone.
/// `frame`: everybody as the scene has them. `goesOn`: gets the share that is done; false gives up.
/// Error: one of them cannot be read, or they have no time in common. Any thread.
[[nodiscard]] model::Result<TakeComparison>
compareTakes(const model::Take& shown, const model::Take& other, const model::Scene& scene,
             const model::CrowdFrame& frame, const std::function<bool(double share)>& goesOn);

} // namespace crowd::widgets
