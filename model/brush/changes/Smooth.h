// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Lets what people have become more like what those around them have.
struct SmoothSettings
{
    float distance = 2.0F; ///< metres to those who count as neighbours
    bool size = true;
    bool heading = false;
    bool timing = false; ///< phase and playback speed
    bool walkSpeed = false;
    bool colours = false;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const SmoothSettings&, const SmoothSettings&) = default;
};

inline constexpr BrushInfo SmoothSettings::kInfo{
    .id = "smooth",
    .name = QT_TRANSLATE_NOOP("Tools", "Smooth Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Sm&ooth"),
    .tip = QT_TRANSLATE_NOOP("Actions",
                             "Let the characters under the brush become like their neighbours"),
    .shortcut = "Shift+F",
    .order = 20,
    .section = BrushSection::Any,
    .scriptKind = "SMOOTH",
    .scriptName = "smooth",
    .scriptClass = "SmoothSettings",
    .doc = "What becomes like the neighbours' values.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: let characters become like their neighbours"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters smoothed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Smooth %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them are like their neighbours"),
    .buildsUp = true,
    .flows = true};

constexpr auto SmoothSettings::fields()
{
    using S = SmoothSettings;
    return std::tuple(
        field(&S::distance, {.key = "distance",
                             .label = QT_TRANSLATE_NOOP("Fields", "Neighbours within"),
                             .doc = "Metres.",
                             .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                             .low = 0.1,
                             .high = 1000.0,
                             .sliderLow = 0.5,
                             .sliderHigh = 20.0,
                             .step = 0.5,
                             .decimals = 1,
                             .isLogarithmic = true,
                             .section = QT_TRANSLATE_NOOP("Fields", "Smooth")}),
        field(&S::size, {.key = "size", .label = QT_TRANSLATE_NOOP("Fields", "Size")}),
        field(&S::heading, {.key = "heading", .label = QT_TRANSLATE_NOOP("Fields", "Heading")}),
        field(&S::timing, {.key = "timing",
                           .label = QT_TRANSLATE_NOOP("Fields", "Timing"),
                           .tip = QT_TRANSLATE_NOOP("Fields", "Phase and speed of their clips")}),
        field(&S::walkSpeed,
              {.key = "walk_speed", .label = QT_TRANSLATE_NOOP("Fields", "Walking speed")}),
        field(&S::colours, {.key = "colours",
                            .label = QT_TRANSLATE_NOOP("Fields", "Colours"),
                            .tip = QT_TRANSLATE_NOOP("Fields", "Of those of the same template")}));
}

} // namespace crowd::model
