// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Shows or hides parts: hats, bags, what hands hold.
struct PartsSettings
{
    std::string part;       ///< by name; empty: all
    bool isShown = true;    ///< else it is hidden
    float percent = 100.0F; ///< of those under the brush; the others stay as they are

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const PartsSettings&, const PartsSettings&) = default;
};

inline constexpr BrushInfo PartsSettings::kInfo{
    .id = "parts",
    .name = QT_TRANSLATE_NOOP("Tools", "Parts Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Parts"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Show or hide hats, bags and other parts"),
    .shortcut = "Shift+P",
    .order = 35,
    .section = BrushSection::Look,
    .scriptKind = "PARTS",
    .scriptName = "parts",
    .scriptClass = "PartsSettings",
    .doc = "Which parts people show.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: show or hide parts of characters"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters given other parts"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Change the parts of %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them already are like that")};

constexpr auto PartsSettings::fields()
{
    using S = PartsSettings;
    return std::tuple(field(&S::part, {.key = "part",
                                       .label = QT_TRANSLATE_NOOP("Fields", "Part"),
                                       .doc = "By name; empty: all.",
                                       .role = FieldRole::Part,
                                       .section = QT_TRANSLATE_NOOP("Fields", "Parts"),
                                       .isRemembered = false}),
                      field(&S::isShown, {.key = "is_shown",
                                          .label = QT_TRANSLATE_NOOP("Fields", "Show it"),
                                          .tip = QT_TRANSLATE_NOOP("Fields", "Else it is hidden")}),
                      field(&S::percent, {.key = "percent",
                                          .label = QT_TRANSLATE_NOOP("Fields", "How many"),
                                          .doc = "Percent of those under the brush.",
                                          .unit = " %",
                                          .high = 100.0,
                                          .sliderHigh = 100.0,
                                          .step = 5.0,
                                          .decimals = 0}));
}

} // namespace crowd::model
