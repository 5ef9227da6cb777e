// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"
#include "model/scene/Path.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Says with which clip and how fast people walk.
struct StyleSettings
{
    bool setsStyle = true;
    std::vector<ClipWeight> clips; ///< to walk with; empty: the one that fits the speed
    bool setsSpeed = true;
    ValueRange speed{1.1F, 1.5F}; ///< m/s

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    friend bool operator==(const StyleSettings&, const StyleSettings&) = default;
};

inline constexpr BrushInfo StyleSettings::kInfo{
    .id = "style",
    .name = QT_TRANSLATE_NOOP("Tools", "Walking Style Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Walking St&yle"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Set with which clip and how fast characters walk"),
    .shortcut = "R",
    .order = 100,
    .section = BrushSection::Motion,
    .scriptKind = "STYLE",
    .scriptName = "style",
    .scriptClass = "StyleSettings",
    .doc = "How people walk, and how fast.",
    .hint =
        QT_TRANSLATE_NOOP("BrushTool", "Drag: set how characters walk and how fast · + −: speed"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters walk in another way"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Set how %n character(s) walk"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already walk like this"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote =
        QT_TRANSLATE_NOOP("Fields", "Drag a line: from the slower to the faster along it.")};

constexpr auto StyleSettings::fields()
{
    using S = StyleSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::setsStyle,
              {.key = "sets_style",
               .label = QT_TRANSLATE_NOOP("Fields", "Change how they walk"),
               .tip = QT_TRANSLATE_NOOP(
                   "Fields", "With which clip characters walk. None: what fits the speed. A clip "
                             "that stays in place is left out."),
               .section = QT_TRANSLATE_NOOP("Fields", "Walk with")}),
        field(&S::clips, {.key = "clips",
                          .label = QT_TRANSLATE_NOOP("Fields", "Clips"),
                          .doc = "Name → weight of clips to walk with; empty: what fits the speed.",
                          .role = FieldRole::WalkingClips}),
        field(&S::setsSpeed, {.key = "sets_speed",
                              .label = QT_TRANSLATE_NOOP("Fields", "Change the speed"),
                              .section = QT_TRANSLATE_NOOP("Fields", "Speed")}),
        field(&S::speed, {.key = "speed",
                          .label = QT_TRANSLATE_NOOP("Fields", "Walking"),
                          .doc = "m/s, (lowest, highest).",
                          .unit = QT_TRANSLATE_NOOP("Fields", " m/s"),
                          .high = kMaxWalkingSpeed,
                          .sliderLow = 0.0,
                          .sliderHigh = 6.0})
            .when([](const S& s, const C&) { return s.setsSpeed; }));
}

} // namespace crowd::model
