// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;
struct TakenFrom;

/// Marks people with a tag that rules ask for.
struct TagSettings
{
    std::uint8_t tag = 0; ///< bit

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static MainNumber mainNumber(const BrushSettings& brush);
    static void setMainNumber(BrushSettings& brush, float value);
    static ChangeResult change(const ChangeRequest& request);
    static std::string take(BrushSettings& brush, const TakenFrom& from);
    friend bool operator==(const TagSettings&, const TagSettings&) = default;
};

/// Takes the tag off again.
struct UntagSettings : TagSettings
{
    static const BrushInfo kInfo;
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const UntagSettings&, const UntagSettings&) = default;
};

inline constexpr BrushInfo TagSettings::kInfo{
    .id = "tag",
    .name = QT_TRANSLATE_NOOP("Tools", "Tag Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Tag"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Tag the characters under the brush, for rules to ask for"),
    .shortcut = "T",
    .order = 130,
    .section = BrushSection::Mind,
    .scriptKind = "TAG",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: tag characters · + −: which tag"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters tagged"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Tag %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already have this tag")};

inline constexpr BrushInfo UntagSettings::kInfo{
    .id = "untag",
    .name = QT_TRANSLATE_NOOP("Tools", "Untag Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Untag"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Take a tag off the characters under the brush"),
    .shortcut = "U",
    .order = 140,
    .section = BrushSection::Mind,
    .scriptKind = "UNTAG",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: take the tag off characters · + −: which tag"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters without the tag"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Untag %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "None of them has this tag")};

constexpr auto TagSettings::fields()
{
    return std::tuple(field(&TagSettings::tag, {.key = "tag",
                                                .label = QT_TRANSLATE_NOOP("Fields", "Tag"),
                                                .doc = "Of the tag brushes: the bit, 0–63.",
                                                .high = 63.0,
                                                .step = 1.0,
                                                .decimals = 0,
                                                .role = FieldRole::Tag,
                                                .section = QT_TRANSLATE_NOOP("Fields", "Tag"),
                                                .isRemembered = false}));
}

} // namespace crowd::model
