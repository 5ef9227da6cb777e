// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

enum class PushMode : std::uint8_t {
    Push,   ///< along the stroke
    Gather, ///< towards each other
    Spread, ///< apart, until there is the wanted distance
    Comb    ///< along the stroke, turned to it
};

inline constexpr FieldChoice kPushModes[] = {
    {"PUSH", QT_TRANSLATE_NOOP("Fields", "Push along")},
    {"GATHER", QT_TRANSLATE_NOOP("Fields", "Gather")},
    {"SPREAD", QT_TRANSLATE_NOOP("Fields", "Spread apart")},
    {"COMB", QT_TRANSLATE_NOOP("Fields", "Comb")}};

/// Moves those who stand, on the ground, most in the middle of the brush. Nobody comes nearer to
/// another than bodies have room.
struct PushSettings
{
    PushMode mode = PushMode::Push;
    float strength = 1.0F; ///< 1: as far as the pointer goes
    float distance = 1.0F; ///< metres: spread until they are so far from each other

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const PushSettings&, const PushSettings&) = default;
};

inline constexpr BrushInfo PushSettings::kInfo{
    .id = "push",
    .name = QT_TRANSLATE_NOOP("Tools", "Push Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Push"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Push, gather, spread or comb the characters"),
    .shortcut = "Shift+D",
    .order = 30,
    .section = BrushSection::Crowd,
    .scriptKind = "PUSH",
    .scriptName = "push",
    .scriptClass = "PushSettings",
    .doc = "How people are moved on the ground.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: push characters about"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters pushed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Push %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "There is no room to push them"),
    .buildsUp = true,
    .movesPeople = true};

constexpr auto PushSettings::fields()
{
    using S = PushSettings;
    using C = FieldContext;
    return std::tuple(field(&S::mode, {.key = "mode",
                                       .label = QT_TRANSLATE_NOOP("Fields", "Movement"),
                                       .choices = kPushModes,
                                       .section = QT_TRANSLATE_NOOP("Fields", "Push")}),
                      field(&S::strength, {.key = "strength",
                                           .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                                           .unit = " %",
                                           .sliderLow = 5.0,
                                           .sliderHigh = 100.0,
                                           .step = 5.0,
                                           .decimals = 0,
                                           .shownScale = 100.0}),
                      field(&S::distance, {.key = "distance",
                                           .label = QT_TRANSLATE_NOOP("Fields", "Distance"),
                                           .doc = "Metres.",
                                           .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                                           .low = 0.1,
                                           .high = 1000.0,
                                           .sliderLow = 0.4,
                                           .sliderHigh = 5.0,
                                           .step = 0.1,
                                           .decimals = 1})
                          .when([](const S& s, const C&) { return s.mode == PushMode::Spread; }));
}

} // namespace crowd::model
