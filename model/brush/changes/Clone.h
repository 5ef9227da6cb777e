// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Gives others what one individual has: as it has it when the stroke is painted.
struct CloneSettings
{
    std::uint32_t source = 0; ///< IndividualId; 0: nobody is chosen
    bool templateToo = true;
    bool looks = true; ///< tints, materials and parts
    bool size = true;
    bool heading = false;
    bool clips = true;
    bool timing = false;  ///< phase and playback speed
    bool walking = false; ///< path, speed and style
    bool tags = false;
    bool group = false;

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static ChangeResult change(const ChangeRequest& request);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    friend bool operator==(const CloneSettings&, const CloneSettings&) = default;
};

inline constexpr BrushInfo CloneSettings::kInfo{
    .id = "clone",
    .name = QT_TRANSLATE_NOOP("Tools", "Clone Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Clone"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Give the characters under the brush what another one has"),
    .shortcut = "Shift+C",
    .order = 10,
    .section = BrushSection::Any,
    .scriptKind = "CLONE",
    .scriptName = "clone",
    .scriptClass = "CloneSettings",
    .doc = "What people get of one of them.",
    .hint = QT_TRANSLATE_NOOP(
        "BrushTool", "Ctrl+click: whom to clone · Drag: give characters what that one has"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters made alike"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Make %n character(s) alike"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them are like that already")};

constexpr auto CloneSettings::fields()
{
    using S = CloneSettings;
    return std::tuple(
        field(&S::source, {.key = "source",
                           .label = QT_TRANSLATE_NOOP("Fields", "Character"),
                           .tip = QT_TRANSLATE_NOOP("Fields", "Ctrl+click somebody to choose"),
                           .doc = "Id of an individual; 0: none chosen.",
                           .high = std::numeric_limits<std::uint32_t>::max(),
                           .step = 1.0,
                           .decimals = 0,
                           .section = QT_TRANSLATE_NOOP("Fields", "Clone"),
                           .isRemembered = false,
                           .zero = QT_TRANSLATE_NOOP("Fields", "none chosen")}),
        field(&S::templateToo,
              {.key = "template_too", .label = QT_TRANSLATE_NOOP("Fields", "Template")}),
        field(&S::looks, {.key = "looks",
                          .label = QT_TRANSLATE_NOOP("Fields", "Colours and materials"),
                          .tip = QT_TRANSLATE_NOOP("Fields", "Parts too")}),
        field(&S::size, {.key = "size", .label = QT_TRANSLATE_NOOP("Fields", "Size")}),
        field(&S::heading, {.key = "heading", .label = QT_TRANSLATE_NOOP("Fields", "Heading")}),
        field(&S::clips, {.key = "clips", .label = QT_TRANSLATE_NOOP("Fields", "Clips")}),
        field(&S::timing, {.key = "timing",
                           .label = QT_TRANSLATE_NOOP("Fields", "Timing"),
                           .tip = QT_TRANSLATE_NOOP("Fields", "Phase and speed of their clips")}),
        field(&S::walking, {.key = "walking",
                            .label = QT_TRANSLATE_NOOP("Fields", "Walking"),
                            .tip = QT_TRANSLATE_NOOP("Fields", "Path, speed and way of walking")}),
        field(&S::tags, {.key = "tags", .label = QT_TRANSLATE_NOOP("Fields", "Tags")}),
        field(&S::group, {.key = "group", .label = QT_TRANSLATE_NOOP("Fields", "Group")}));
}

} // namespace crowd::model
