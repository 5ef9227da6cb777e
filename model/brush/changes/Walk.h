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

/// Says which path people follow, and how fast.
struct WalkSettings
{
    bool setsPath = true;
    PathId path = 0; ///< 0: follow none; kNearestPath: the one that each is nearest to
    bool setsSpeed = true;
    ValueRange speed{1.1F, 1.5F}; ///< m/s

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    friend bool operator==(const WalkSettings&, const WalkSettings&) = default;
};

inline constexpr BrushInfo WalkSettings::kInfo{
    .id = "walk",
    .name = QT_TRANSLATE_NOOP("Tools", "Walk Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Walk"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Let the characters under the brush walk along a path"),
    .shortcut = "W",
    .order = 90,
    .section = BrushSection::Way,
    .scriptKind = "WALK",
    .scriptName = "walk",
    .scriptClass = "WalkSettings",
    .doc = "Which path people follow, and how fast.",
    .hint = QT_TRANSLATE_NOOP("BrushTool",
                              "Drag: let characters walk along the path · + −: walking speed"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters walk differently"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Set the walk of %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already walk like this")};

constexpr auto WalkSettings::fields()
{
    using S = WalkSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::setsPath,
              {.key = "sets_path",
               .label = QT_TRANSLATE_NOOP("Fields", "Change the path"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Characters walk along it when it plays"),
               .section = QT_TRANSLATE_NOOP("Fields", "Path")}),
        field(
            &S::path,
            {.key = "path",
             .label = QT_TRANSLATE_NOOP("Fields", "Follow"),
             .doc = "Id of a path; 0: follow none; NEAREST_PATH: the one that each is nearest to.",
             .high = 4294967295.0,
             .role = FieldRole::Path,
             .isRemembered = false})
            .when([](const S& s, const C&) { return s.setsPath; }),
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
