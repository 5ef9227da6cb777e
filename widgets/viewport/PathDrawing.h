// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <QtCore/QPointF>
#include <QtCore/QString>
#include <QtGui/QColor>

#include "model/view/View.h"
#include "render/RenderInput.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// A handle or a name over the picture, logical pixels.
struct PlaceLabel
{
    QPointF at;
    QString text; ///< empty: only the handle
    QColor color;
    bool isSelected = false;
    friend bool operator==(const PlaceLabel&, const PlaceLabel&) = default;
};

/// Places as rings and paths as lanes with arrows, flat on the ground, and their names. Made anew
/// only when they changed.
class PathDrawing
{
public:
    /// Triangles of everything; the current path is stronger.
    [[nodiscard]] std::span<const render::OverlayTriangle> areas(const EditorState& state);
    [[nodiscard]] static std::vector<PlaceLabel> labels(const EditorState& state,
                                                        const model::View& view);
    /// Something else is to be drawn.
    void forget() { m_isStale = true; }

private:
    void draw(const EditorState& state);
    void ring(const model::Place& place, glm::vec4 color);
    void lane(const model::Place& from, const model::Place& to, glm::vec4 color, bool isJump);

    std::vector<render::OverlayTriangle> m_areas;
    bool m_isStale = true;
};

} // namespace crowd::widgets
