// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionParts.h"
#include "behavior/session/SessionPose.h"
#include "behavior/session/SessionTally.h"

/// What a session lets others see of its people.
namespace crowd::behavior {

/// Everybody whom the session moves, as of its last step.
[[nodiscard]] SessionPosePtr capturePose(const SessionParts& parts);

/// Everybody as of the last step, for the renderer.
[[nodiscard]] model::CrowdFrame captureFrame(const SessionParts& parts);

/// People counted, as of the last step.
[[nodiscard]] SessionTally countPeople(const SessionParts& parts);

} // namespace crowd::behavior
