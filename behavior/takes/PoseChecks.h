// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionPose.h"

namespace crowd::behavior {

/// Whether a pose that was read from a file can be shown: its columns are as long as each other,
/// ids ascend, all numbers are numbers.
[[nodiscard]] bool isSound(const SessionPose& pose);
/// The same of what rules or states have made of one property.
[[nodiscard]] bool isSound(model::ColumnId column, const OverrideColumn& values);
[[nodiscard]] bool isSound(const FadeTimes& times);
[[nodiscard]] bool isSound(const FadeColumn& column);
[[nodiscard]] bool isSound(const model::LightCues& cues);

} // namespace crowd::behavior
