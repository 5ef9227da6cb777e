// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// What the left button does in the picture: one for each brush, and those without.
#define CROWD_BRUSH_TOOL(name, settings) Brush##name,
enum class ToolId : std::uint8_t { Select, Navigate, CROWD_BRUSHES(CROWD_BRUSH_TOOL) Count };
#undef CROWD_BRUSH_TOOL

/// What menus, palettes and tool bars need to know of a tool.
struct ToolInfo
{
    ToolId id;
    const char* stableId; ///< action id and icon name: "brush-create" is icons/brush-create.svg
    const char* name;     ///< to be translated in the context "Tools"
    const char* shortcut; ///< default key, portable text
    std::optional<model::BrushKind> brush;
};

/// In the order in which they are shown.
[[nodiscard]] std::span<const ToolInfo> toolTable();
[[nodiscard]] const ToolInfo& toolInfo(ToolId id);
/// The brush that a tool paints with, if it is one.
[[nodiscard]] std::optional<model::BrushKind> brushKindOf(ToolId id);
[[nodiscard]] ToolId toolOf(model::BrushKind kind);

} // namespace crowd::widgets
