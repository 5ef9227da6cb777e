// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct PathEnded
{
    static constexpr KindText kText{.key = "path ended",
                                    .name = QT_TRANSLATE_NOOP("Rules", "a path ends"),
                                    .doc = "Somebody reaches the end of a simple path."};

    PathId path = 0; ///< 0: any; kNotChosen

    static constexpr auto fields()
    {
        return std::tuple(field(
            &PathEnded::path,
            rulefields::path({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any path")})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<PathEnded>{
            QT_TRANSLATE_NOOP("Rules", "When someone reaches the end of {path}")}};
    }
    friend bool operator==(const PathEnded&, const PathEnded&) = default;
};

} // namespace crowd::model::triggers
