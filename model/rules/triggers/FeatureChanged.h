// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct FeatureChanged
{
    static constexpr KindText kText{.key = "feature",
                                    .name = QT_TRANSLATE_NOOP("Rules", "a feature changes"),
                                    .doc = "Somebody bears another value of a feature than before, "
                                           "whoever gave it."};

    std::uint32_t feature = 0; ///< 0: any

    static constexpr auto fields()
    {
        return std::tuple(
            field(&FeatureChanged::feature,
                  rulefields::feature({.doc = "the id of the one that he bears now; 0: any",
                                       .zero = QT_TRANSLATE_NOOP("Rules", "any")})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<FeatureChanged>{
                              QT_TRANSLATE_NOOP("Rules", "When a feature of someone changes"),
                              [](const FeatureChanged& s) { return s.feature == 0; }},
                          Sentence<FeatureChanged>{
                              QT_TRANSLATE_NOOP("Rules", "When someone becomes “{feature}”")}};
    }
    friend bool operator==(const FeatureChanged&, const FeatureChanged&) = default;
};

} // namespace crowd::model::triggers
