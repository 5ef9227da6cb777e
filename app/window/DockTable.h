// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <QtCore/Qt>

class QDockWidget;
class QWidget;

namespace crowd::widgets {
class EditorState;
}

/// The panels of the window, each described once: what makes it and where it is in a new
/// installation. Layouts are remembered by the object names that panels give themselves.
namespace crowd::app {

class Interpreter;
class Recorder;

/// In the order in which they are placed, and in which the menu lists them.
enum class DockId : std::uint8_t {
    Brushes,
    BrushSettings,
    Templates,
    Colour,
    Individual,
    Scene,
    Environment,
    Rules,
    History,
    Strokes,
    Presets,
    Groups,
    States,
    Features,
    Relations,
    Light,
    Looks,
    Timeline,
    Takes,
    Console,
    Count
};

/// What panels look at; outlives them, save for the parent, which owns them.
struct DockParts
{
    widgets::EditorState& state;
    Interpreter& interpreter;
    Recorder& recorder;
    QWidget* parent;
};

struct DockInfo
{
    DockId id;
    QDockWidget* (*make)(const DockParts& parts);
    Qt::DockWidgetArea area;
    /// Logical pixels, of one behind another while it is in front; 0: that of the first of them.
    int height = 0;
    int width = 0;                       ///< of its area; 0: as it comes
    std::optional<DockId> tabAfter = {}; ///< behind this one
    bool isShown = true;                 ///< else only when it is asked for
    const char* action = nullptr;        ///< that shows it with keys of its own; null: none
};

/// All of them, in the order of DockId.
[[nodiscard]] std::span<const DockInfo> dockTable();

} // namespace crowd::app
