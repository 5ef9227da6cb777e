// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

struct ChangeRequest;
struct ChangeResult;

/// Gives people back what their template has.
struct RestoreSettings
{
    bool colours = true;   ///< no tints
    bool materials = true; ///< the first of each slot
    bool parts = true;     ///< those that are shown by default
    bool size = false;     ///< 1
    bool clips = false;    ///< what suits standing or sitting, at speed 1

    static const BrushInfo kInfo;
    static constexpr auto fields();
    static void prepare(BrushSettings& brush);
    static ChangeResult change(const ChangeRequest& request);
    friend bool operator==(const RestoreSettings&, const RestoreSettings&) = default;
};

inline constexpr BrushInfo RestoreSettings::kInfo{
    .id = "restore",
    .name = QT_TRANSLATE_NOOP("Tools", "Restore Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "&Restore"),
    .tip = QT_TRANSLATE_NOOP("Actions",
                             "Give the characters under the brush back what their template has"),
    .shortcut = "Shift+R",
    .order = 40,
    .section = BrushSection::Any,
    .scriptKind = "RESTORE",
    .scriptName = "restore",
    .scriptClass = "RestoreSettings",
    .doc = "What people get back from their template.",
    .hint = QT_TRANSLATE_NOOP("BrushTool", "Drag: restore what the template has"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters restored"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "Restore %n character(s)"),
    .unchanged = QT_TRANSLATE_NOOP("Brushes", "All of them are as their template has it")};

constexpr auto RestoreSettings::fields()
{
    using S = RestoreSettings;
    return std::tuple(
        field(&S::colours, {.key = "colours",
                            .label = QT_TRANSLATE_NOOP("Fields", "Colours"),
                            .section = QT_TRANSLATE_NOOP("Fields", "Restore")}),
        field(&S::materials,
              {.key = "materials", .label = QT_TRANSLATE_NOOP("Fields", "Materials")}),
        field(&S::parts, {.key = "parts", .label = QT_TRANSLATE_NOOP("Fields", "Parts")}),
        field(&S::size, {.key = "size", .label = QT_TRANSLATE_NOOP("Fields", "Size")}),
        field(&S::clips, {.key = "clips",
                          .label = QT_TRANSLATE_NOOP("Fields", "Clips"),
                          .tip = QT_TRANSLATE_NOOP(
                              "Fields", "What suits standing or sitting, at the usual speed")}));
}

} // namespace crowd::model
