// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "behavior/session/MotionCache.h"
#include "behavior/session/SessionPose.h"

namespace crowd::behavior {

/// Takes steps in the order of time; false: it has enough.
using StepSink = std::function<bool(const SessionPosePtr& pose)>;
/// A step, and the one after it (the same at the end); null: they cannot be read.
using StepsAround = std::function<std::pair<SessionPosePtr, SessionPosePtr>(double seconds)>;

/// Gives some steps of a run, one after the other; null: there are none.
using EarlierSteps = std::function<void(const StepSink& sink)>;

/// A moment of an earlier run that another one goes on from.
struct RunBeginning
{
    SessionPosePtr before; ///< the step before `now`; at the run's beginning that itself
    SessionPosePtr now;
    EarlierSteps earlier; ///< all before `now`
};

/// Those of what has been played that are earlier than a time.
[[nodiscard]] EarlierSteps stepsBefore(const std::shared_ptr<MotionCache>& run, double end);

/// At the step that is shown at a time, of steps that are read one after the other, `first` the
/// time of the first of them. What `around` refers to lives as long as the beginning. Nothing: it
/// cannot be read.
[[nodiscard]] std::optional<RunBeginning> beginningIn(const StepsAround& around, double first,
                                                      double seconds);
/// The same of what has been played.
[[nodiscard]] std::optional<RunBeginning> beginningIn(const std::shared_ptr<MotionCache>& run,
                                                      double seconds);

} // namespace crowd::behavior
