// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct FollowPath
{
    static constexpr KindText kText{.key = "follow",
                                    .name = QT_TRANSLATE_NOOP("Rules", "walk along a path"),
                                    .doc = "Walks along a path.",
                                    .beginsGroup = true,
                                    .isWalk = true};

    PathId path = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&FollowPath::path, rulefields::path({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<FollowPath>{QT_TRANSLATE_NOOP("Rules", "walk along {path}")}};
    }
    friend bool operator==(const FollowPath&, const FollowPath&) = default;
};

} // namespace crowd::model::actions
