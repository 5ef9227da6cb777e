// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// What the left button does in the picture.
enum class ToolId : std::uint8_t {
    Select,
    Navigate,
    BrushCreate,
    BrushDelete,
    BrushColour,
    BrushOrientation,
    BrushAnimation,
    BrushPath,
    BrushWalk,
    BrushStyle,
    BrushEnvironment,
    BrushEvent,
    BrushTag,
    BrushUntag,
    BrushScript, ///< the one of EditorState::scriptBrushes() that was chosen last
    Count
};

/// What menus, palettes and tool bars need to know of a tool, in the order in which it is shown.
struct ToolInfo
{
    ToolId id;
    const char* stableId; ///< action id and icon name: "brush-create" is icons/brush-create.svg
    const char* name;     ///< to be translated in the context "Tools"
    const char* shortcut; ///< default key, portable text
    std::optional<model::BrushKind> brush;
};

[[nodiscard]] const std::array<ToolInfo, static_cast<std::size_t>(ToolId::Count)>& toolTable();
[[nodiscard]] const ToolInfo& toolInfo(ToolId id);
/// The brush that a tool paints with, if it is one.
[[nodiscard]] std::optional<model::BrushKind> brushKindOf(ToolId id);
[[nodiscard]] ToolId toolOf(model::BrushKind kind);

inline constexpr std::size_t kBrushCount = 13;
/// How a brush is set when the editor starts.
[[nodiscard]] model::BrushSettings initialBrush(model::BrushKind kind);

} // namespace crowd::widgets
