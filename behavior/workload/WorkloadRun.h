// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "behavior/workload/Workload.h"

namespace crowd::behavior {

/// What a run shows beside its time.
struct WorkloadFigures
{
    double overlapsPer1000 = 0.0; ///< pairs closer than 0.4 m per 1000 people, worst of all samples
    double efficiency = 0.0;      ///< mean progress to the goal / preferred speed
    double rmsAcceleration = 0.0; ///< m/s²
    double outsideWalls = 0.0;    ///< share of people, worst of all samples
    std::size_t brokenNumbers = 0; ///< coordinates that are no numbers
    double bytesPerAgent = 0.0;
    std::vector<double> stepMs; ///< steering and stepping, without measuring
};

/// Steps the workload and watches. `clockMs` tells the time in milliseconds; null: none is taken.
/// `beforeStep` hears the number of each step, from 0 on, before it is timed.
[[nodiscard]] WorkloadFigures runWorkload(Workload& workload, int steps, double (*clockMs)(),
                                          const std::function<void(int)>& beforeStep = {});

} // namespace crowd::behavior
