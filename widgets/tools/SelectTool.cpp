// SPDX-License-Identifier: MIT
#include "widgets/tools/SelectTool.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>

#include "model/brush/MoveDrag.h"
#include "widgets/tools/BrushDrags.h"
#include "widgets/tools/LightHandles.h"
#include "widgets/tools/PlaceCorners.h"
#include "widgets/tools/PlaceHandles.h"
#include "widgets/tools/PlaceHits.h"

namespace crowd::widgets {

using model::IndividualId;

namespace {

/// A hand that clicks trembles this much, logical pixels.
constexpr double kClickSlack = 4.0;

struct SelectToolText
{
    Q_DECLARE_TR_FUNCTIONS(SelectTool)
};

bool isClick(const QPointF& from, const QPointF& to)
{
    return (to - from).manhattanLength() <= kClickSlack;
}

/// A drag draws a rectangle or a lasso; a click selects whom it hit, if anybody, else clears.
/// Nothing changes before release.
class AreaSelect : public DragSession
{
public:
    AreaSelect(const ToolContext& context, const ToolInput& press, std::optional<IndividualId> hit)
        : m_context(context), m_press(press), m_current(press), m_hit(hit),
          m_isLasso(context.state.viewOptions().selectsByLasso), m_way{press.position()}
    {
    }

    void update(const ToolInput& input) override
    {
        m_current = input;
        m_way << input.position();
    }

    void tick(const ToolInput& /*resting*/, double /*elapsedSeconds*/) override
    {
        if (m_counted != m_current.pointer.grid) {
            m_counted = m_current.pointer.grid;
            m_count = isDrag() ? static_cast<int>(inside().size()) : 0;
        }
    }

    void release(const ToolInput& input) override
    {
        update(input);
        const SelectionMode mode = selectionModeFor(input.modifiers);
        if (isDrag()) {
            m_context.state.selection().apply(inside(), mode);
        } else if (m_hit) {
            m_context.state.selection().apply(std::array{*m_hit}, mode);
        } else if (mode == SelectionMode::Replace) {
            m_context.state.selection().clear();
            m_context.state.paths().select({});
            m_context.state.paths().look(pathUnder(m_context, input));
        }
    }

    void cancel() override {}

    void show(ToolPicture& picture) const override
    {
        picture.cursor = Qt::CrossCursor;
        if (!isDrag()) {
            return;
        }
        if (m_isLasso) {
            picture.outlines.push_back(closed(m_way));
        } else {
            picture.rectangle = QRectF(m_press.position(), m_current.position()).normalized();
        }
        picture.symbolAt = m_current.position();
        picture.label = SelectToolText::tr("%n characters", nullptr, m_count);
    }

private:
    /// A lasso ends where it began.
    [[nodiscard]] bool isDrag() const
    {
        return !isClick(m_press.position(), m_current.position()) ||
               (m_isLasso &&
                !isClick(m_way.boundingRect().topLeft(), m_way.boundingRect().bottomRight()));
    }
    [[nodiscard]] model::ScreenArea area() const
    {
        if (!m_isLasso) {
            return model::ScreenArea::rectangle(m_press.pointer.pixels(),
                                                m_current.pointer.pixels());
        }
        std::vector<glm::dvec2> corners;
        for (const QPointF& point : m_way) {
            corners.emplace_back(point.x(), point.y());
        }
        return model::ScreenArea::polygon(std::move(corners));
    }
    [[nodiscard]] std::vector<IndividualId> inside() const
    {
        return m_context.queries.picker(m_current.pointer.shownSeconds)
            .individualsInArea(area(), model::AreaMode::Visible);
    }

    ToolContext m_context;
    ToolInput m_press;
    ToolInput m_current;
    std::optional<IndividualId> m_hit;
    bool m_isLasso;
    QPolygonF m_way; ///< of the pointer
    glm::ivec2 m_counted{-1};
    int m_count = 0;
};

/// Press on somebody who is selected: a click selects him alone, a drag moves all who are.
class ClickOrMove : public DragSession
{
public:
    ClickOrMove(const ToolContext& context, const ToolInput& press, IndividualId hit)
        : m_context(context), m_press(press), m_hit(hit)
    {
    }

    void update(const ToolInput& input) override
    {
        if (!m_move && !isClick(m_press.position(), input.position())) {
            beginMove();
        }
        if (m_move) {
            m_move->move(input.pointer);
        }
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (!m_move) {
            m_context.state.selection().apply(std::array{m_hit}, selectionModeFor(input.modifiers));
            return;
        }
        const model::StrokeOutcome outcome = m_move->finish();
        m_move.reset();
        if (!outcome.isCommitted && !outcome.message.isEmpty()) {
            m_context.state.refuse(outcome.message);
        }
    }

    void cancel() override
    {
        if (m_move) {
            m_move->cancel();
            m_move.reset();
        }
    }

    void show(ToolPicture& picture) const override
    {
        picture.cursor = m_move ? Qt::SizeAllCursor : Qt::ArrowCursor;
        picture.hovered = m_move ? 0 : m_hit;
    }

private:
    void beginMove()
    {
        m_move = model::MoveDrag::begin(
            m_context.state.document(), m_context.queries.brushContext(),
            m_context.state.selection().ids(), m_context.state.isSeatGridOn(), m_press.pointer);
    }

    ToolContext m_context;
    ToolInput m_press;
    IndividualId m_hit;
    std::unique_ptr<model::MoveDrag> m_move;
};

} // namespace

SelectionMode selectionModeFor(Qt::KeyboardModifiers modifiers)
{
    if (modifiers.testFlag(Qt::ControlModifier)) {
        return SelectionMode::Toggle;
    }
    return modifiers.testFlag(Qt::ShiftModifier) ? SelectionMode::Add : SelectionMode::Replace;
}

QString SelectTool::hint() const
{
    return SelectToolText::tr(
        "Click: select · Drag: area, or move who is selected · Shift: add to the selection · "
        "Ctrl: in or out of it · Double click: puts a place into a path, a corner into a line or "
        "takes it out · L: lasso or rectangle · Delete: remove · F: show the selection");
}

DragSessionPtr SelectTool::press(const ToolInput& input)
{
    const bool isPaperRectangle = m_context.state.viewOptions().buttons == ButtonMapping::Paper &&
                                  input.button == Qt::RightButton;
    if (isPaperRectangle) {
        return std::make_unique<AreaSelect>(m_context, input, std::nullopt);
    }
    if (input.button != Qt::LeftButton) {
        return nullptr;
    }
    if (const auto light = lightAt(m_context, input.position())) {
        return lightDrag(m_context, input, *light);
    }
    if (const auto place = placeAt(m_context, input.position())) {
        if (input.isSecond && changeCorners(m_context, input, *place)) {
            return nullptr;
        }
        // Circles cross their path, and touch midway of short ones.
        if (input.isSecond && place->isBorder && insertPlaceUnder(m_context, input)) {
            return nullptr;
        }
        return placeDrag(m_context, input, *place);
    }
    const auto hit =
        m_context.queries.picker(input.pointer.shownSeconds).individualAt(input.pointer.pixels());
    if (!hit && input.isSecond && insertPlaceUnder(m_context, input)) {
        return nullptr;
    }
    if (!hit) {
        return std::make_unique<AreaSelect>(m_context, input, std::nullopt);
    }
    if (selectionModeFor(input.modifiers) != SelectionMode::Replace ||
        !m_context.state.selection().contains(hit->id)) {
        // In a dense crowd there is no empty ground to begin a rectangle on.
        return std::make_unique<AreaSelect>(m_context, input, hit->id);
    }
    return std::make_unique<ClickOrMove>(m_context, input, hit->id);
}

void SelectTool::hover(const ToolInput& /*input*/, ToolPicture& picture) const
{
    picture.cursor = Qt::ArrowCursor;
}

void SelectTool::preview(const ToolInput& input, ToolPicture& picture) const
{
    if (lightAt(m_context, input.position())) {
        picture.hovered = 0;
        picture.cursor = Qt::SizeAllCursor;
        return;
    }
    if (const auto place = placeAt(m_context, input.position())) {
        picture.hovered = 0;
        picture.cursor = place->isBorder ? Qt::SizeHorCursor : Qt::SizeAllCursor;
        return;
    }
    const auto hit =
        m_context.queries.picker(input.pointer.shownSeconds).individualAt(input.pointer.pixels());
    picture.hovered = hit ? hit->id : 0;
    const bool isMovable = hit && m_context.state.selection().contains(hit->id);
    picture.cursor = isMovable ? Qt::SizeAllCursor : hit ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

} // namespace crowd::widgets
