// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/Tool.h"

namespace crowd::widgets {

enum class Navigation : unsigned char { Orbit, Pan, Dolly };

/// Moves the view while a button is held: around, along, or towards what was under the cursor.
/// Escape goes back to where it began.
class NavigateDrag : public DragSession
{
public:
    NavigateDrag(const ToolContext& context, Navigation kind, const ToolInput& press);

    void update(const ToolInput& input) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    void show(ToolPicture& picture) const override;

private:
    ToolContext m_context;
    Navigation m_kind;
    ViewCamera m_before;
    glm::vec3 m_anchor;
    QPointF m_last;
};

/// Which way a button with these modifiers moves the view: alone it orbits, with Shift it pans,
/// with Control it goes nearer or farther.
[[nodiscard]] Navigation navigationFor(Qt::KeyboardModifiers modifiers);

/// The wheel: towards the point under the cursor, smoothly.
class WheelDolly
{
public:
    void turn(const ToolContext& context, const WheelInput& input);

private:
    QPointF m_at{-1e6, -1e6};
    double m_seconds = -1e6;
    glm::vec3 m_anchor{0.0F};
};

/// Navigate mode: the left button orbits, the middle one pans, the right one flies.
class NavigateTool : public Tool
{
public:
    explicit NavigateTool(const ToolContext& context) : m_context(context) {}

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] DragSessionPtr press(const ToolInput& input) override;
    void hover(const ToolInput& input, ToolPicture& picture) const override;

private:
    ToolContext m_context;
};

} // namespace crowd::widgets
