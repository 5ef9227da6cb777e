// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Who of those under the brush is related to whom.
enum class RelationHow : std::uint8_t {
    FromTo,   ///< those where the stroke begins to those where it ends
    Chain,    ///< each to the one before on the way
    Family,   ///< a few of the nearest with one another
    Near,     ///< each to some around him
    Together, ///< each to each
};

/// Relates people with each other, or takes relations away. The kind goes by name, so that a brush
/// serves every scene that has such.
struct RelationSettings
{
    std::string relation = "friends";
    RelationHow how = RelationHow::FromTo;
    bool erases = false;
    ValueRange strength{1.0F, 1.0F}; ///< drawn for each relation
    std::uint32_t least = 2;         ///< Family
    std::uint32_t most = 6;
    std::uint32_t count = 2; ///< Near
    float metres = 3.0F;     ///< Near, Family: farthest
    /// FromTo by an area: from whom. None: whom the area holds is asked for, and nobody is related.
    std::vector<int> sources;

    static constexpr bool kHasOperator = false; ///< strengths are drawn, whatever it is
    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    friend bool operator==(const RelationSettings&, const RelationSettings&) = default;
};

inline constexpr BrushInfo RelationSettings::kInfo{
    .id = "relation",
    .name = QT_TRANSLATE_NOOP("Tools", "Relation Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Re&lation"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Relate characters: friends, families, couples, leaders"),
    .shortcut = "Shift+L",
    .order = 127,
    .section = BrushSection::Mind,
    .scriptKind = "RELATION",
    .scriptName = "relation",
    .scriptClass = "RelationSettings",
    .doc = "Who of those under the brush is related to whom.",
    .hint = QT_TRANSLATE_NOOP("BrushTool",
                              "Drag from one to another: relate them · Ctrl+drag: take it away"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "Relations of %n characters changed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Change relations of %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "Their relations are like that already")};

inline constexpr std::array kRelationHows{
    FieldChoice{"from to", QT_TRANSLATE_NOOP("Fields", "From A to B"),
                QT_TRANSLATE_NOOP("Fields", "Those where the stroke begins to those where it ends; "
                                            "with a rectangle or lasso those of the first one to "
                                            "those of the second")},
    FieldChoice{"chain", QT_TRANSLATE_NOOP("Fields", "Chain"),
                QT_TRANSLATE_NOOP("Fields", "Each to the one before on the way of the brush")},
    FieldChoice{"family", QT_TRANSLATE_NOOP("Fields", "Small groups"),
                QT_TRANSLATE_NOOP("Fields", "A few of the nearest are related with one another, as "
                                            "families are: two of another look, and smaller ones "
                                            "with them")},
    FieldChoice{"near", QT_TRANSLATE_NOOP("Fields", "Some around"),
                QT_TRANSLATE_NOOP("Fields", "Each to a few of those around, drawn at random")},
    FieldChoice{"together", QT_TRANSLATE_NOOP("Fields", "Each to each"),
                QT_TRANSLATE_NOOP("Fields", "All whom the stroke touches, with one another")}};

constexpr auto RelationSettings::fields()
{
    using S = RelationSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::relation, {.key = "relation",
                             .label = QT_TRANSLATE_NOOP("Fields", "Relation"),
                             .doc = "Name of a kind of relation: \"friends\", \"family\".",
                             .role = FieldRole::RelationKind,
                             .section = QT_TRANSLATE_NOOP("Fields", "Relation")}),
        field(
            &S::how,
            {.key = "how", .label = QT_TRANSLATE_NOOP("Fields", "Who"), .choices = kRelationHows}),
        field(&S::least, {.key = "least",
                          .label = QT_TRANSLATE_NOOP("Fields", "At least"),
                          .doc = "Small groups: the fewest members.",
                          .low = 2.0,
                          .high = 20.0,
                          .sliderLow = 2.0,
                          .sliderHigh = 8.0,
                          .step = 1.0,
                          .decimals = 0})
            .when([](const S& s, const C&) { return s.how == RelationHow::Family; }),
        field(&S::most, {.key = "most",
                         .label = QT_TRANSLATE_NOOP("Fields", "At most"),
                         .doc = "Small groups: the most members.",
                         .low = 2.0,
                         .high = 20.0,
                         .sliderLow = 2.0,
                         .sliderHigh = 8.0,
                         .step = 1.0,
                         .decimals = 0})
            .when([](const S& s, const C&) { return s.how == RelationHow::Family; }),
        field(&S::count, {.key = "count",
                          .label = QT_TRANSLATE_NOOP("Fields", "How many"),
                          .doc = "Some around: how many each is related to.",
                          .low = 1.0,
                          .high = 20.0,
                          .sliderLow = 1.0,
                          .sliderHigh = 8.0,
                          .step = 1.0,
                          .decimals = 0})
            .when([](const S& s, const C&) { return s.how == RelationHow::Near; }),
        field(&S::metres, {.key = "metres",
                           .label = QT_TRANSLATE_NOOP("Fields", "Within"),
                           .doc = "Small groups, some around: how far they are apart at most.",
                           .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                           .low = 0.1,
                           .high = 1000.0,
                           .sliderLow = 0.5,
                           .sliderHigh = 20.0,
                           .step = 0.5,
                           .decimals = 1})
            .when([](const S& s, const C&) {
                return s.how == RelationHow::Near || s.how == RelationHow::Family;
            }),
        field(&S::strength, {.key = "strength",
                             .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                             .tip = QT_TRANSLATE_NOOP("Fields", "How much they mean to each other; "
                                                                "drawn for each relation"),
                             .doc = "Drawn for each relation, 0–1.",
                             .step = 0.05})
            .when([](const S& s, const C&) { return !s.erases; }),
        field(&S::erases,
              {.key = "erases",
               .label = QT_TRANSLATE_NOOP("Fields", "Take it away"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Relations of this kind go that those under the "
                                                  "brush have; Ctrl while painting does the same"),
               .doc = "Takes relations of the kind away that people have."}),
        field(&S::sources, {.key = "sources",
                            .doc = "From A to B by a rectangle or lasso: ids of those from whom.",
                            .high = 2147483647.0,
                            .isRemembered = false}));
}

} // namespace crowd::model
