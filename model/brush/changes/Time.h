// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

enum class TimeMode : std::uint8_t {
    Range,  ///< delays of a range, by the operator
    Wave,   ///< the further along the stroke, the later
    Ripple, ///< the further from where the stroke began, the later
    InStep  ///< all at once
};

inline constexpr FieldChoice kTimeModes[] = {
    {"RANGE", QT_TRANSLATE_NOOP("Fields", "Within a range")},
    {"WAVE", QT_TRANSLATE_NOOP("Fields", "Wave along the stroke")},
    {"RIPPLE", QT_TRANSLATE_NOOP("Fields", "Ripple from the press")},
    {"IN_STEP", QT_TRANSLATE_NOOP("Fields", "All in step")}};

/// Lets people begin their clips sooner or later, whatever clip each has.
struct TimeSettings
{
    TimeMode mode = TimeMode::Range;
    ValueRange delay{0.0F, 2.0F}; ///< seconds
    float waveSpeed = 8.0F;       ///< m/s

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const TimeSettings&, const TimeSettings&) = default;
};

inline constexpr BrushInfo TimeSettings::kInfo{
    .id = "time",
    .name = QT_TRANSLATE_NOOP("Tools", "Time Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Time"),
    .tip = QT_TRANSLATE_NOOP("Actions",
                             "Let the characters under the brush begin sooner or later: waves"),
    .shortcut = "Shift+T",
    .order = 60,
    .section = BrushSection::Motion,
    .scriptKind = "TIME",
    .scriptName = "time",
    .scriptClass = "TimeSettings",
    .doc = "When people begin their clips.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Drag: set when characters begin · + −: seconds, or the wave's speed"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters begin at another time"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Set the time of %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already begin then"),
    .operatorPlace = OperatorPlace::Last,
    .gradientNote = QT_TRANSLATE_NOOP("Fields", "From the shortest to the longest delay along the "
                                                "line that is drawn."),
    .isTogether = true};

constexpr auto TimeSettings::fields()
{
    using S = TimeSettings;
    using C = FieldContext;
    return std::tuple(
        field(&S::mode, {.key = "mode",
                         .label = QT_TRANSLATE_NOOP("Fields", "They begin"),
                         .choices = kTimeModes,
                         .section = QT_TRANSLATE_NOOP("Fields", "Time")}),
        field(&S::delay, {.key = "delay",
                          .label = QT_TRANSLATE_NOOP("Fields", "Delay"),
                          .doc = "Seconds, (shortest, longest).",
                          .unit = QT_TRANSLATE_NOOP("Fields", " s"),
                          .high = 3600.0,
                          .sliderHigh = 10.0,
                          .step = 0.1,
                          .decimals = 2})
            .when([](const S& s, const C&) {
                return s.mode == TimeMode::Range || s.mode == TimeMode::InStep;
            }),
        field(&S::waveSpeed, {.key = "wave_speed",
                              .label = QT_TRANSLATE_NOOP("Fields", "Speed of the wave"),
                              .doc = "Metres a second.",
                              .unit = QT_TRANSLATE_NOOP("Fields", " m/s"),
                              .low = 0.1,
                              .high = 1000.0,
                              .sliderLow = 1.0,
                              .sliderHigh = 50.0,
                              .step = 1.0,
                              .decimals = 1,
                              .isLogarithmic = true})
            .when([](const S& s, const C&) {
                return s.mode == TimeMode::Wave || s.mode == TimeMode::Ripple;
            }));
}

} // namespace crowd::model
