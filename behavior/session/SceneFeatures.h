// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionParts.h"

namespace crowd::behavior {

/// At the end of a step: who was told so by a rule bears another value of a feature, in the session
/// alone, with all that it does.
void takeOnFeatures(SessionParts& parts);

} // namespace crowd::behavior
