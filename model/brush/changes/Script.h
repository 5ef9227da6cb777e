// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/brush/BrushInfo.h"
#include "model/describe/Field.h"

namespace crowd::model {

/// A setting that a script brush brings along.
struct ScriptValue
{
    std::string name;
    std::variant<bool, std::int64_t, double, std::string, PaintColor> value;
    friend bool operator==(const ScriptValue&, const ScriptValue&) = default;
};

/// What it changes, a script says.
struct ScriptSettings
{
    std::string brush; ///< the name it was registered by
    std::vector<ScriptValue> values;

    static const BrushInfo kInfo;
    static constexpr auto fields() { return std::tuple(); }
    friend bool operator==(const ScriptSettings&, const ScriptSettings&) = default;
};

inline constexpr BrushInfo ScriptSettings::kInfo{
    .id = "script",
    .name = QT_TRANSLATE_NOOP("Tools", "Script Brush"),
    .menu = QT_TRANSLATE_NOOP("Actions", "Scr&ipt"),
    .tip = QT_TRANSLATE_NOOP("Actions", "Paint with a brush that a script brought along"),
    .shortcut = "S",
    .order = 150,
    .section = BrushSection::Any,
    .scriptKind = "SCRIPT",
    .hint = QT_TRANSLATE_NOOP("BrushTool",
                              "Drag: let the script change characters · Escape: take it back"),
    .done = QT_TRANSLATE_N_NOOP("BrushTool", "%n characters changed"),
    .undo = QT_TRANSLATE_N_NOOP("Brushes", "%1: %n character(s)")};

} // namespace crowd::model
