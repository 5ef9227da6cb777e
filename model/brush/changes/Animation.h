// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Gives people other clips, phases and playback speeds.
struct AnimationSettings
{
    std::vector<ClipWeight> clips; ///< empty: the clip stays
    bool setsPhase = true;
    ValueRange phase{0.0F, 1.0F}; ///< Uniform takes low; Gradient runs from low to high
    bool setsSpeed = false;
    ValueRange speed{1.0F, 1.0F};

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const AnimationSettings&, const AnimationSettings&) = default;
};

inline constexpr BrushInfo AnimationSettings::kInfo{
    .id = "animation",
    .name = QT_TRANSLATE_NOOP("Tools", "Animation Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Animation"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Give the characters under the brush another animation"),
    .shortcut = "A",
    .order = 50,
    .section = BrushSection::Motion,
    .scriptKind = "ANIMATION",
    .scriptName = "animation",
    .scriptClass = "AnimationSettings",
    .doc = "What people do.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Drag: change what characters do · + −: speed · Ctrl+click: take the clip"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters move differently"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Animate %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already move like this"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the lower to the higher values along it."),
    .buildsUp = true};

constexpr auto AnimationSettings::fields()
{
    using S = AnimationSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::clips, {.key = "clips",
                          .label = QT_TRANSLATE_NOOP("Fields", "Clips"),
                          .doc = "Name → weight; empty: unchanged.",
                          .section = QT_TRANSLATE_NOOP("Fields", "Clips (none: as they are)")}),
        field(&S::setsPhase, {.key = "sets_phase",
                              .label = QT_TRANSLATE_NOOP("Fields", "Change the phase"),
                              .section = QT_TRANSLATE_NOOP("Fields", "Timing")}),
        field(&S::phase, {.key = "phase",
                          .label = QT_TRANSLATE_NOOP("Fields", "Phase"),
                          .doc = "(lowest, highest), 0–1 of the clip at time 0.",
                          .step = 0.05})
            .when([](const S& s, const C&) { return s.setsPhase; }),
        field(&S::setsSpeed,
              {.key = "sets_speed", .label = QT_TRANSLATE_NOOP("Fields", "Change the speed")}),
        field(&S::speed, {.key = "speed",
                          .label = QT_TRANSLATE_NOOP("Fields", "Speed"),
                          .doc = "(lowest, highest), 1 as authored.",
                          .high = 100.0,
                          .sliderLow = 0.0,
                          .sliderHigh = 4.0,
                          .step = 0.05})
            .when([](const S& s, const C&) { return s.setsSpeed; }));
}

} // namespace crowd::model
