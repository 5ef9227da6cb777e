// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QtCore/QLineF>
#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QString>
#include <QtCore/Qt>
#include <QtGui/QPolygonF>

#include "render/RenderInput.h"
#include "widgets/state/ToolId.h"

namespace crowd::widgets {

/// The exact area of a round brush on screen, logical pixels.
struct CircleOutline
{
    QPointF center;
    double radius = 0.0;
};

/// What a tool wants to be seen: said as data, drawn by the viewport. Logical pixels.
struct ToolPicture
{
    // In the scene.
    std::vector<render::Ghost> ghosts;
    model::IndividualId hovered = 0;
    // Over it.
    std::optional<CircleOutline> circle;
    std::optional<QPointF> crosshair; ///< a brush that takes a single point
    std::vector<QPointF> candidates;  ///< on whom a press would work, where they are seen
    std::optional<QRectF> rectangle;
    std::optional<QLineF> gradient;
    std::vector<QPolygonF> outlines; ///< places to come, closed
    std::optional<QLineF> arrow;     ///< the way to the place to come
    std::optional<QPointF> target;   ///< the point that people are to face
    /// The spray can with the brush's symbol beside the cursor.
    std::optional<ToolId> symbol;
    QPointF symbolAt;
    QString label; ///< at the cursor: "24 people", "32 px"
    QString mode;  ///< above the picture, while something unusual goes on
    Qt::CursorShape cursor = Qt::ArrowCursor;
};

/// Whether ghosts and hovered person are the same, so that the scene need not be drawn again.
[[nodiscard]] bool showsTheSameInScene(const ToolPicture& a, const ToolPicture& b);

} // namespace crowd::widgets
