// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/describe/Field.h"
#include "model/population/Columns.h"

namespace crowd::model {

struct Scene;
struct MaskSettings;

[[nodiscard]] bool hasGroups(const FieldContext& context);

/// On whom a brush may work at all, whatever its area holds. Lists that are empty ask nothing; who
/// is meant fulfils all that ask.
struct MaskSettings
{
    bool onlySelected = false;
    std::vector<int> selected;  ///< ids, ascending: the selected ones, as of the press
    std::vector<int> templates; ///< ids
    std::vector<int> groups;    ///< ids; 0: those in none
    std::vector<int> tags;      ///< bits, one of which is worn
    std::vector<int> features;  ///< ids of values, one of which is borne
    bool isInverted = false;    ///< all but these

    [[nodiscard]] bool asksNothing() const
    {
        return !onlySelected && templates.empty() && groups.empty() && tags.empty() &&
               features.empty();
    }
    static constexpr auto fields();
    friend bool operator==(const MaskSettings&, const MaskSettings&) = default;
};

/// Who of a scene may be touched, as of when it is made: those whom the mask means and whose group
/// is neither hidden nor locked.
class StrokeMask
{
public:
    StrokeMask(const Scene& scene, const MaskSettings& mask);

    enum class Verdict : std::uint8_t { Meant, Masked, Locked };
    [[nodiscard]] Verdict verdict(std::size_t row) const
    {
        return m_verdicts.empty() ? Verdict::Meant : m_verdicts[row];
    }

private:
    std::vector<Verdict> m_verdicts; ///< by row; empty: everybody is meant
};

constexpr auto MaskSettings::fields()
{
    using S = MaskSettings;
    using C = FieldContext;
    constexpr double kMost = std::numeric_limits<int>::max();
    return std::tuple(
        field(&S::onlySelected,
              {.key = "only_selected",
               .label = QT_TRANSLATE_NOOP("Fields", "Only the selected"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Paint on the selected characters alone"),
               .doc = "Only those in `selected`, which the editor fills with the selected ones.",
               .section = QT_TRANSLATE_NOOP("Fields", "Mask"),
               .isRemembered = false}),
        field(&S::selected, {.key = "selected",
                             .doc = "Ids. Assign a whole list.",
                             .high = kMost,
                             .isRemembered = false}),
        field(&S::templates, {.key = "templates",
                              .label = QT_TRANSLATE_NOOP("Fields", "Templates"),
                              .doc = "Ids of templates; empty: all. Assign a whole list.",
                              .high = kMost,
                              .role = FieldRole::Template,
                              .isRemembered = false,
                              .zero = QT_TRANSLATE_NOOP("Fields", "all")}),
        field(&S::groups, {.key = "groups",
                           .label = QT_TRANSLATE_NOOP("Fields", "Groups"),
                           .doc = "Ids of groups, 0: in none; empty: all. Assign a whole list.",
                           .high = kMost,
                           .role = FieldRole::Group,
                           .isRemembered = false,
                           .zero = QT_TRANSLATE_NOOP("Fields", "all")})
            .when([](const S&, const C& c) { return hasGroups(c); }),
        field(&S::tags, {.key = "tags",
                         .label = QT_TRANSLATE_NOOP("Fields", "Tags"),
                         .doc = "Bits 0–63, any of which is worn; empty: all. Assign a whole list.",
                         .high = 63.0,
                         .role = FieldRole::Tag,
                         .isRemembered = false,
                         .zero = QT_TRANSLATE_NOOP("Fields", "all")}),
        field(&S::features,
              {.key = "features",
               .label = QT_TRANSLATE_NOOP("Fields", "Features"),
               .doc = "Ids of values of features, any of which is borne; empty: all. Assign a "
                      "whole list.",
               .high = 65535.0,
               .role = FieldRole::Feature,
               .isRemembered = false,
               .zero = QT_TRANSLATE_NOOP("Fields", "all")}),
        field(&S::isInverted,
              {.key = "inverted",
               .label = QT_TRANSLATE_NOOP("Fields", "All but these"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Paint on those whom the mask leaves out"),
               .isRemembered = false})
            .when([](const S& s, const C&) { return !s.asksNothing(); }));
}

} // namespace crowd::model
