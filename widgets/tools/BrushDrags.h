// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/brush/Stroke.h"
#include "widgets/tools/ScriptPainter.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Where the pointer went while a brush was pressed, and what there is to see of it.
class PressedWay
{
public:
    PressedWay(const model::BrushSettings& settings, const ToolInput& press)
        : m_settings(settings), m_press(press), m_current(press), m_way{press.position()}
    {
    }

    /// What is to be done there, now or later: no picture shows the places in between, and so
    /// what is evaluated anew from press to here need not be there.
    enum class Work { Paint, Pass, None };
    [[nodiscard]] Work moved(const ToolInput& input);
    /// Time goes on; `painted`: where it was painted last.
    [[nodiscard]] Work rested(const ToolInput& resting, const glm::ivec2& painted);
    void ended(const ToolInput& input) { m_current = input; }

    [[nodiscard]] const model::BrushSettings& settings() const { return m_settings; }
    [[nodiscard]] const model::PointerInput& pointer() const { return m_current.pointer; }
    void show(ToolPicture& picture, int affected) const;

private:
    model::BrushSettings m_settings;
    ToolInput m_press;
    ToolInput m_current;
    QPolygonF m_way;
};

/// A stroke of the brush: applied while the button is held, one undo step on release, none after
/// Escape. Says why when nothing came of it.
class StrokeDrag : public DragSession
{
public:
    StrokeDrag(const ToolContext& context, const model::BrushSettings& settings, std::uint64_t seed,
               const ToolInput& press);

    void update(const ToolInput& input) override;
    void tick(const ToolInput& resting, double elapsedSeconds) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    void show(ToolPicture& picture) const override;

private:
    void paint();
    void showGathered();

    ToolContext m_context;
    std::unique_ptr<model::Stroke> m_stroke;
    PressedWay m_way;
    std::vector<model::IndividualId> m_selectedBefore;
};

/// A stroke of a script brush: it goes on, and is taken back, where scripts run.
class ScriptStrokeDrag : public DragSession
{
public:
    /// The painter has begun the stroke.
    ScriptStrokeDrag(ScriptPainter& painter, const model::BrushSettings& settings,
                     const ToolInput& press);
    ~ScriptStrokeDrag() override;

    void update(const ToolInput& input) override;
    void tick(const ToolInput& resting, double elapsedSeconds) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    void show(ToolPicture& picture) const override;

private:
    void paint();

    ScriptPainter& m_painter;
    PressedWay m_way;
    glm::ivec2 m_painted; ///< where it did so last
    bool m_isOver = false;
};

/// Back to where it began.
[[nodiscard]] QPolygonF closed(QPolygonF way);

/// What a stroke did, for the status bar.
[[nodiscard]] QString affectedText(model::BrushKind kind, int count);

/// Shift and dragging sideways: the circle stays where it is and grows or shrinks.
class ResizeDrag : public DragSession
{
public:
    ResizeDrag(const ToolContext& context, model::BrushKind kind, const ToolInput& press);

    void update(const ToolInput& input) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    void show(ToolPicture& picture) const override;

private:
    ToolContext m_context;
    model::BrushSettings m_before;
    QPointF m_press;
};

/// Outline and symbol of a brush at the cursor.
void showBrush(const model::BrushSettings& settings, const QPointF& at, double pressure,
               ToolPicture& picture);

} // namespace crowd::widgets
