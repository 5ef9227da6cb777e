// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionParts.h"
#include "behavior/session/SessionPose.h"

namespace crowd::behavior {

/// People of a session that has made no step yet are on the move, as they were from one pose of a
/// run to its next. Who is in neither begins at rest.
void beginOnTheMove(SessionParts& parts, const SessionPose& before, const SessionPose& now);

/// They are where and as they were in a pose: where they stand or sit, whether they have left, what
/// rules and states have made of them, and the clip that they show, which goes on to its end.
/// Whoever has a path follows it from there. Rules begin anew. The clock is at that moment.
void beginAsIn(SessionParts& parts, const SessionPose& pose);

} // namespace crowd::behavior
