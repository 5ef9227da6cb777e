// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Tints slots.
struct ColourSettings
{
    std::string slot;        ///< by name; empty: all tintable slots
    bool sparesBody = false; ///< of all, not skin, hair and face, where there is anything else
    /// The colour as it was chosen, whatever the material's; else it multiplies that one.
    bool replaces = false;
    /// Uniform takes the first; Random one of them, or between them with `blends`; Gradient runs
    /// through them from first to last. Never empty.
    std::vector<PaintColor> colors{{214, 64, 48}, {48, 96, 214}};
    float strength = 1.0F; ///< 0..1
    bool blends = false;
    bool eachSlotApart = false; ///< Random: another draw for each slot

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const ColourSettings&, const ColourSettings&) = default;
};

inline constexpr BrushInfo ColourSettings::kInfo{
    .id = "colour",
    .name = QT_TRANSLATE_NOOP("Tools", "Colour Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "C&olour"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Recolour the characters under the brush"),
    .shortcut = "B",
    .order = 30,
    .section = BrushSection::Look,
    .scriptKind = "COLOUR",
    .scriptName = "colour",
    .scriptClass = "ColourSettings",
    .doc = "Tints of slots.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Drag: colour characters · + −: strength · Ctrl+click: take the colour"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters coloured"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Colour %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already have this colour"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the first to the last colour along it."),
    .buildsUp = true,
    .flows = true,
    .dropper = Dropper::Colour};

/// Whether values are drawn.
[[nodiscard]] bool isDrawn(const FieldContext& context);

inline constexpr FieldChoice kTintModes[] = {{"multiply", QT_TRANSLATE_NOOP("Fields", "Multiply")},
                                             {"replace", QT_TRANSLATE_NOOP("Fields", "Replace")}};

constexpr auto ColourSettings::fields()
{
    using S = ColourSettings;
    const auto whereDrawn = [](const S&, const FieldContext& c) { return isDrawn(c); };
    return std::tuple(
        field(&S::slot, {.key = "slot",
                         .label = QT_TRANSLATE_NOOP("Fields", "Slot"),
                         .doc = "By name; empty: all tintable slots.",
                         .role = FieldRole::Slot,
                         .section = QT_TRANSLATE_NOOP("Fields", "Paint"),
                         .isRemembered = false}),
        field(&S::sparesBody,
              {.key = "spares_body",
               .doc = "Of all slots, not skin, hair and face, where there is anything else.",
               .isRemembered = false}),
        field(&S::replaces,
              {.key = "replaces",
               .label = QT_TRANSLATE_NOOP("Fields", "Mode"),
               .doc = "The colour itself, whatever the material's; else it multiplies that one.",
               .choices = kTintModes}),
        field(&S::colors, {.key = "colors",
                           .doc = "List of (red, green, blue), 0–255. Assign a whole list.",
                           .low = 1.0,
                           .high = 256.0}),
        field(&S::strength, {.key = "strength",
                             .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                             .doc = "0–1.",
                             .unit = " %",
                             .sliderLow = 0.0,
                             .sliderHigh = 100.0,
                             .step = 5.0,
                             .decimals = 0,
                             .shownScale = 100.0}),
        field(&S::blends,
              {.key = "blends",
               .label = QT_TRANSLATE_NOOP("Fields", "Blend the colours"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "Also what lies between the colours, not only one of them")})
            .when(whereDrawn),
        field(&S::eachSlotApart,
              {.key = "each_slot_apart",
               .label = QT_TRANSLATE_NOOP("Fields", "Each slot its own"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Another colour for each slot of a character")})
            .when(whereDrawn));
}

} // namespace crowd::model
