// SPDX-License-Identifier: MIT
#include "widgets/tools/ShapeDrag.h"

#include <cmath>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include <glm/geometric.hpp>

#include "model/base/Segment.h"
#include "model/document/SceneEdit.h"
#include "model/scene/PlaceShape.h"
#include "widgets/tools/EnvironmentPlaces.h"
#include "widgets/tools/PlaceHandles.h"
#include "widgets/tools/PlaceHits.h"

namespace crowd::widgets {

namespace {

struct ShapeDragText
{
    Q_DECLARE_TR_FUNCTIONS(ShapeDrag)
};

constexpr double kShapeClickSlack = 5.0; ///< pixels; a drag goes farther
constexpr double kClosingPixels = 9.0;   ///< about the first corner
constexpr double kTrailPixels = 3.0;     ///< from one point of a drag to the next
constexpr float kTrailMetres = 0.1F;     ///< what is drawn freely may be so much straighter

const model::EnvironmentSettings& brushOf(const ToolContext& context)
{
    return context.state.brush(model::BrushKind::Environment).as<model::EnvironmentSettings>();
}

/// The place that the next corner goes to; null: the brush makes something else by now.
const model::Place* shapedPlace(const ToolContext& context)
{
    const model::Place* place = context.state.scene().findPlace(context.state.paths().shaped());
    const model::EnvironmentSettings& brush = brushOf(context);
    const bool isOfBrush = place != nullptr && place->role == brush.role &&
                           (place->shape == brush.shape || place->corners.size() < 3);
    return isOfBrush ? place : nullptr;
}

std::vector<glm::vec3> cornersSoFar(const model::Place& place)
{
    return place.shape == model::PlaceShape::Round ? std::vector{place.position}
                                                   : model::cornersOf(place);
}

/// Whether the pointer is where the place began, and that has an inside by now.
bool closesShape(const ToolContext& context, const model::Place& place, const QPointF& pixel)
{
    const std::vector<glm::vec3> corners = cornersSoFar(place);
    const auto first = context.queries.view().project(corners.front());
    return corners.size() > 2 && first &&
           QLineF(pixel, QPointF(first->x, first->y)).length() < kClosingPixels;
}

/// A post, then a line, then what the brush makes.
void shapeBy(model::Place& place, const std::vector<glm::vec3>& corners, model::PlaceShape wanted)
{
    if (corners.size() < 2) {
        return;
    }
    place.shape = corners.size() < 3 ? model::PlaceShape::Line : wanted;
    model::setCorners(place, corners);
}

/// Without the points that lie nearly on the way between others (Douglas and Peucker, 1973).
void keepBends(const std::vector<glm::vec3>& trail, std::size_t first, std::size_t last,
               std::vector<glm::vec3>& kept)
{
    float farthest = kTrailMetres;
    std::size_t bend = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const float share = model::nearestShare(trail[i], trail[first], trail[last]);
        const float off =
            glm::distance(trail[i], trail[first] + share * (trail[last] - trail[first]));
        if (off > farthest) {
            farthest = off;
            bend = i;
        }
    }
    if (bend != first) {
        keepBends(trail, first, bend, kept);
        keepBends(trail, bend, last, kept);
        return;
    }
    kept.push_back(trail[last]);
}

class ShapeDrag : public DragSession
{
public:
    ShapeDrag(const ToolContext& context, const ToolInput& press)
        : m_context(context), m_press(press), m_current(press),
          m_hasBegun(shapedPlace(context) == nullptr)
    {
        if (press.isSecond) { // also where the click before has closed it
            endPath(context.state);
            m_isOver = true;
            return;
        }
        const model::Place* place = shapedPlace(context);
        if (place != nullptr && closesShape(context, *place, press.position())) {
            close(*place);
            return;
        }
        if (const auto ground = groundUnder(context, press)) {
            context.state.showStatus({}); // of the click before
            m_trail = {*ground};
        } else {
            context.state.refuse(ShapeDragText::tr(
                "Nothing to stand on there: the pointer is on the sky, or on something upright. "
                "Click on the ground beside it."));
            m_isOver = true;
        }
    }

    void update(const ToolInput& input) override
    {
        const bool isDrag =
            m_trail.size() > 1 ||
            QLineF(input.position(), m_press.position()).length() > kShapeClickSlack;
        const auto ground = groundUnder(m_context, input);
        if (!m_isOver && isDrag && ground &&
            QLineF(input.position(), m_current.position()).length() > kTrailPixels) {
            m_trail.push_back(*ground);
            m_current = input;
        }
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (m_isOver) {
            return;
        }
        const bool isDrawn = m_trail.size() > 1;
        std::vector<glm::vec3> corners{m_trail.front()};
        if (isDrawn) {
            keepBends(m_trail, 0, m_trail.size() - 1, corners);
        }
        add(corners,
            isDrawn ? ShapeDragText::tr("Draw corners") : ShapeDragText::tr("Add a corner"));
        if (m_hasBegun && isDrawn) {
            endPath(m_context.state);
        }
    }
    void cancel() override {}

    void show(ToolPicture& picture) const override
    {
        picture.cursor = Qt::CrossCursor;
        picture.symbol = ToolId::BrushEnvironment;
        picture.symbolAt = m_current.position();
        const model::View view = m_context.queries.view();
        QPolygonF trail;
        for (const glm::vec3& point : m_trail) {
            if (const auto pixel = view.project(point)) {
                trail << QPointF(pixel->x, pixel->y);
            }
        }
        if (trail.size() > 1) {
            picture.outlines.push_back(std::move(trail));
        }
    }

private:
    void add(const std::vector<glm::vec3>& points, const QString& text)
    {
        EditorState& state = m_context.state;
        const model::Place* shaped = shapedPlace(m_context);
        if (shaped == nullptr) {
            begin(points);
            return;
        }
        model::Place place = *shaped;
        std::vector<glm::vec3> corners = cornersSoFar(place);
        corners.insert(corners.end(), points.begin(), points.end());
        shapeBy(place, corners, brushOf(m_context).shape);
        if (!model::isWhole(place)) {
            sayTooMuch();
            return;
        }
        state.document().edit(text, [&](model::SceneEdit& edit) { edit.changePlace(place); });
    }

    void begin(const std::vector<glm::vec3>& points)
    {
        const model::EnvironmentSettings& brush = brushOf(m_context);
        model::Place post;
        post.position = points.front();
        post.radius = brush.shape == model::PlaceShape::Line ? 0.5F * brush.widthMetres
                                                             : model::kMinPlaceRadius;
        shapeBy(post, points, brush.shape);
        if (!model::isWhole(post)) {
            sayTooMuch();
            return;
        }
        m_context.state.paths().shape(addEnvironment(m_context.state, post));
    }

    void sayTooMuch() const
    {
        m_context.state.refuse(
            ShapeDragText::tr("That is too far away or has more than %1 corners: press Enter, and "
                              "begin another one.")
                .arg(model::kMostCorners));
    }

    void close(model::Place place)
    {
        if (place.shape == model::PlaceShape::Line) {
            std::vector<glm::vec3> corners = model::cornersOf(place);
            corners.push_back(corners.front());
            if (corners.size() <= model::kMostCorners) {
                model::setCorners(place, corners);
                m_context.state.document().edit(
                    ShapeDragText::tr("Close a line"),
                    [&](model::SceneEdit& edit) { edit.changePlace(place); });
            }
        }
        m_context.state.paths().end();
        m_isOver = true;
    }

    ToolContext m_context;
    ToolInput m_press;
    ToolInput m_current;
    bool m_hasBegun = false; ///< another place, with this press
    bool m_isOver = false;   ///< there is nothing left to draw
    std::vector<glm::vec3> m_trail;
};

} // namespace

DragSessionPtr shapeDrag(const ToolContext& context, const ToolInput& press)
{
    return std::make_unique<ShapeDrag>(context, press);
}

void showShapeToCome(const ToolContext& context, const ToolInput& input, ToolPicture& picture)
{
    const model::View view = context.queries.view();
    const model::Place* place = shapedPlace(context);
    const auto ground = groundUnder(context, input);
    if (place == nullptr || !ground) {
        return;
    }
    const glm::vec3 last = cornersSoFar(*place).back();
    if (const auto from = view.project(last)) {
        picture.arrow = QLineF(QPointF(from->x, from->y), input.position());
    }
    picture.label = closesShape(context, *place, input.position())
                        ? ShapeDragText::tr("Close it")
                        : ShapeDragText::tr("%1 m").arg(QLocale().toString(
                              static_cast<double>(glm::distance(last, *ground)), 'f', 2));
}

} // namespace crowd::widgets
