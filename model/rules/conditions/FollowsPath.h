// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct FollowsPath
{
    static constexpr KindText kText{.key = "follows",
                                    .name = QT_TRANSLATE_NOOP("Rules", "walking path"),
                                    .doc = "Walks along a path.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "walks along a path")};

    PathId path = 0; ///< 0: any

    static constexpr auto fields()
    {
        return std::tuple(field(
            &FollowsPath::path,
            rulefields::path({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any path")})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<FollowsPath>{QT_TRANSLATE_NOOP("Rules", "walking {path}"),
                                                nullptr,
                                                QT_TRANSLATE_NOOP("Rules", "not walking {path}")}};
    }
    friend bool operator==(const FollowsPath&, const FollowsPath&) = default;
};

} // namespace crowd::model::conditions
