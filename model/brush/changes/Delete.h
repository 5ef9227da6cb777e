// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// Removes people.
struct DeleteSettings
{
    float percent = 100.0F; ///< of those in the area, for thinning out; a spray takes whom it hits

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    friend bool operator==(const DeleteSettings&, const DeleteSettings&) = default;
};

inline constexpr BrushInfo DeleteSettings::kInfo{
    .id = "delete",
    .name = QT_TRANSLATE_NOOP("Tools", "Delete Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Delete"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Spray characters away"),
    .shortcut = "X",
    .order = 20,
    .section = BrushSection::Crowd,
    .scriptKind = "DELETE",
    .scriptName = "removal",
    .scriptClass = "DeleteSettings",
    .doc = "How many are removed.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: delete characters · + −: how fast"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters deleted"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Delete %n character(s)")};

[[nodiscard]] bool takesShare(const FieldContext& context);

constexpr auto DeleteSettings::fields()
{
    return std::tuple(
        field(&DeleteSettings::percent, {.key = "percent",
                                         .label = QT_TRANSLATE_NOOP("Fields", "Of them"),
                                         .doc = "Of those in the area.",
                                         .unit = " %",
                                         .high = 100.0,
                                         .sliderLow = 5.0,
                                         .sliderHigh = 100.0,
                                         .step = 5.0,
                                         .decimals = 0})
            .when([](const DeleteSettings&, const FieldContext& c) { return takesShare(c); }));
}

} // namespace crowd::model
