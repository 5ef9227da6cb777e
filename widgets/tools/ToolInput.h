// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QPointF>
#include <QtCore/Qt>

#include "model/brush/PointerInput.h"

namespace crowd::widgets {

/// A pointer event as tools see it: what brushes need, and which button it was about.
struct ToolInput
{
    model::PointerInput pointer;
    Qt::MouseButton button = Qt::NoButton; ///< of a press or release
    Qt::KeyboardModifiers modifiers;
    bool isSecond = false; ///< a press: of a double click

    /// Logical pixels in the view.
    [[nodiscard]] QPointF position() const
    {
        const glm::dvec2 pixels = pointer.pixels();
        return {pixels.x, pixels.y};
    }
};

/// A step of the wheel: 1 is one notch, away from the hand.
struct WheelInput
{
    ToolInput at;
    double notches = 0.0;
};

/// A key going down or up; automatic repeats are marked.
struct KeyInput
{
    int key = 0;
    Qt::KeyboardModifiers modifiers;
    bool isRepeat = false;
    double timeSeconds = 0.0;
};

} // namespace crowd::widgets
