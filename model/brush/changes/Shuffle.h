// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Lets people of the same template change places in what is chosen: each value goes on exactly
/// once.
struct ShuffleSettings
{
    bool colours = true; ///< tints, materials and parts together
    bool size = false;
    bool heading = false;
    bool timing = false; ///< phase and playback speed
    bool clips = false;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const ShuffleSettings&, const ShuffleSettings&) = default;
};

inline constexpr BrushInfo ShuffleSettings::kInfo{
    .id = "shuffle",
    .name = QT_TRANSLATE_NOOP("Tools", "Shuffle Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Shu&ffle"),
    .tip =
        QT_TRANSLATE_NOOP("Actions", "Let the characters under the brush exchange what they have"),
    .shortcut = "Shift+S",
    .order = 30,
    .section = BrushSection::Any,
    .scriptKind = "SHUFFLE",
    .scriptName = "shuffle",
    .scriptClass = "ShuffleSettings",
    .doc = "What people of the same template exchange.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: let characters exchange what they have"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters shuffled"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Shuffle %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them have the same"),
    .isTogether = true};

constexpr auto ShuffleSettings::fields()
{
    using S = ShuffleSettings;
    return std::tuple(
        field(&S::colours, {.key = "colours",
                            .label = QT_TRANSLATE_NOOP("Fields", "Colours and materials"),
                            .section = QT_TRANSLATE_NOOP("Fields", "Exchange")}),
        field(&S::size, {.key = "size", .label = QT_TRANSLATE_NOOP("Fields", "Size")}),
        field(&S::heading, {.key = "heading", .label = QT_TRANSLATE_NOOP("Fields", "Heading")}),
        field(&S::timing, {.key = "timing",
                           .label = QT_TRANSLATE_NOOP("Fields", "Timing"),
                           .tip = QT_TRANSLATE_NOOP("Fields", "Phase and speed of their clips")}),
        field(&S::clips, {.key = "clips", .label = QT_TRANSLATE_NOOP("Fields", "Clips")}));
}

} // namespace crowd::model
