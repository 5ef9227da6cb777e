// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/population/ColumnSet.h"
#include "model/population/Population.h"
#include "model/scene/Scene.h"
#include "model/states/RecallTiming.h"

namespace crowd::model {

/// People are about to have other values in some columns, and are seen on their way there.
struct ChangeOver
{
    StateId state = 0;             ///< that they take on
    std::vector<IndividualId> ids; ///< ascending
    ColumnSet columns;
    RecallTiming timing;
};

/// Seconds after which each of them begins, 0 to timing.stagger.seconds. `people`: where they are
/// seen, with the seats that they have; ids ascending, who is not there begins at once. Places that
/// are no numbers count as the nearest. Random ones are the same for the same person and state.
[[nodiscard]] std::vector<float> delaysOf(const ChangeOver& change, const Scene& scene,
                                          const Population& people);

} // namespace crowd::model
