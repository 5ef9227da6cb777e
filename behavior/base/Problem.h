// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/base/Message.h"
#include "model/population/Columns.h"
#include "model/rules/Rule.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// What the artist should know about a session: a sentence, and what of the scene it is about.
struct Problem
{
    model::Message text;
    model::RuleId rule = 0; ///< 0: no rule; so for the others
    model::PlaceId place = 0;
    model::PathId path = 0;
    std::vector<model::IndividualId> people{}; ///< ascending
    friend bool operator==(const Problem& a, const Problem& b)
    {
        // Texts last: they take longest, and thousands may report the same problem in a step.
        return a.rule == b.rule && a.place == b.place && a.path == b.path && a.people == b.people &&
               a.text == b.text;
    }
};

} // namespace crowd::behavior
