// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct AheadFree
{
    static constexpr KindText kText{.key = "ahead free",
                                    .name = QT_TRANSLATE_NOOP("Rules", "the place ahead gets free"),
                                    .doc =
                                        "The place before somebody's in a path's order gets free."};

    PathId path = 0; ///< 0: any; kNotChosen

    static constexpr auto fields()
    {
        return std::tuple(field(
            &AheadFree::path,
            rulefields::path({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any path")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<AheadFree>{
                QT_TRANSLATE_NOOP("Rules", "When the place ahead of someone gets free"),
                [](const AheadFree& s) { return s.path == 0; }},
            Sentence<AheadFree>{
                QT_TRANSLATE_NOOP("Rules", "When the place ahead of someone in {path} gets free")}};
    }
    friend bool operator==(const AheadFree&, const AheadFree&) = default;
};

} // namespace crowd::model::triggers
