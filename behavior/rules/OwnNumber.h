// SPDX-License-Identifier: MIT
#pragma once

#include "model/population/Columns.h"
#include "model/rules/Rule.h"

namespace crowd::behavior {

/// An artist's number of one individual, where rules have changed it since the session began.
struct OwnNumber
{
    model::NumberId number = 0;
    model::IndividualId id = 0;
    float value = 0.0F;
};

} // namespace crowd::behavior
