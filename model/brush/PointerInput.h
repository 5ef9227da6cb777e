// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace crowd::model {

/// Pointer positions lie on a grid of 1/256 logical pixel, so that a stroke is a polyline of whole
/// numbers: the same on every machine, and splitting it into more events changes nothing.
inline constexpr int kPointerGrid = 256;

/// Nearest grid point; ties are broken the same way for every sign. Logical pixels.
[[nodiscard]] glm::ivec2 gridPoint(glm::dvec2 pixels);
/// Logical pixels of a grid point; exact.
[[nodiscard]] constexpr glm::dvec2 pixelsOf(glm::ivec2 grid)
{
    return {grid.x / static_cast<double>(kPointerGrid), grid.y / static_cast<double>(kPointerGrid)};
}

/// Bits of PointerInput::buttons.
enum PointerButton : std::uint8_t { LeftButton = 1, RightButton = 2, MiddleButton = 4 };
/// Bits of PointerInput::modifiers.
enum PointerModifier : std::uint8_t { ShiftModifier = 1, ControlModifier = 2, AltModifier = 4 };

/// One event of a mouse, a tablet or the keyboard's stand-in for them, as brushes and tools see it.
/// Position in the view, logical pixels, origin top left, y down. A pointer that rests sends inputs
/// with an unchanged position (ticks) so that a spray goes on.
struct PointerInput
{
    glm::ivec2 grid{0};    ///< position × kPointerGrid
    float pressure = 1.0F; ///< 0..1, 1 without a pen
    std::uint8_t buttons = 0;
    std::uint8_t modifiers = 0;
    double timeSeconds = 0.0;  ///< the event's own time stamp; only differences matter
    double shownSeconds = 0.0; ///< the transport's time of the picture that was on screen

    [[nodiscard]] glm::dvec2 pixels() const { return pixelsOf(grid); }
    [[nodiscard]] static PointerInput at(glm::dvec2 pixels, double timeSeconds,
                                         double shownSeconds = 0.0);
    friend bool operator==(const PointerInput&, const PointerInput&) = default;
};

} // namespace crowd::model
