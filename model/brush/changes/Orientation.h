// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/brush/Heading.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Turns people.
struct OrientationSettings
{
    HeadingSettings heading{HeadingMode::AlongStroke};

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const OrientationSettings&, const OrientationSettings&) = default;
};

inline constexpr BrushInfo OrientationSettings::kInfo{
    .id = "orientation",
    .name = QT_TRANSLATE_NOOP("Tools", "Orientation Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "O&rientation"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Turn the characters under the brush"),
    .shortcut = "O",
    .order = 40,
    .section = BrushSection::Motion,
    .scriptKind = "ORIENTATION",
    .scriptName = "orientation",
    .scriptClass = "OrientationSettings",
    .doc = "Which way people are turned.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Drag: turn characters · + −: direction · Ctrl+click: the point to face"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters turned"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Turn %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already face this way"),
    .operatorPlace = OperatorPlace::First,
    .gradientNote = QT_TRANSLATE_NOOP("Fields", "Drag a line: they face along it."),
    .buildsUp = true,
    .flows = true,
    .dropper = Dropper::Point};

[[nodiscard]] bool isGradient(const FieldContext& context);

constexpr auto OrientationSettings::fields()
{
    return std::tuple(field(&OrientationSettings::heading, {.key = "facing"})
                          .when([](const OrientationSettings&, const FieldContext& c) {
                              return !isGradient(c);
                          }));
}

} // namespace crowd::model
