// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/population/Columns.h"
#include "model/rules/Rule.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// What the artist should know about a session: a sentence, and what of the scene it is about.
struct Problem
{
    std::string text;
    model::RuleId rule = 0; ///< 0: no rule; so for the others
    model::PlaceId place = 0;
    model::PathId path = 0;
    std::vector<model::IndividualId> people{}; ///< ascending
    friend bool operator==(const Problem&, const Problem&) = default;
};

} // namespace crowd::behavior
