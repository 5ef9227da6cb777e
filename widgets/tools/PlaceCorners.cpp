// SPDX-License-Identifier: MIT
#include "widgets/tools/PlaceCorners.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QLineF>

#include <glm/geometric.hpp>

#include "model/base/Segment.h"
#include "model/document/SceneEdit.h"
#include "model/scene/PlaceShape.h"

namespace crowd::widgets {

namespace {

struct PlaceCornersText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceCorners)
};

constexpr double kCornerSlack = 4.0;

/// A line that comes back to where it began has its first corner twice: both move.
void moveCorner(std::vector<glm::vec3>& corners, std::size_t corner, const glm::vec3& to)
{
    const glm::vec3 from = corners[corner];
    const bool isEnd = corner == 0 || corner + 1 == corners.size();
    if (isEnd && corners.front() == from && corners.back() == from) {
        corners.front() = to;
        corners.back() = to;
    }
    corners[corner] = to;
}

class CornerDrag : public DragSession
{
public:
    CornerDrag(const ToolContext& context, const ToolInput& press, const PlaceHit& hit)
        : m_context(context), m_press(press), m_hit(hit)
    {
    }

    void update(const ToolInput& input) override
    {
        const bool isDrag =
            m_edit || QLineF(input.position(), m_press.position()).length() > kCornerSlack;
        const auto ground = groundUnder(m_context, input);
        if (!isDrag || !ground) {
            return;
        }
        if (!m_edit && !begin()) {
            return;
        }
        std::vector<glm::vec3> corners = model::cornersOf(m_before);
        moveCorner(corners, *m_hit.corner, *ground);
        model::Place place = m_before;
        model::setCorners(place, corners);
        if (model::isWhole(place)) {
            m_edit->changePlace(place);
        }
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (!m_edit) {
            m_context.state.paths().select({m_hit.place});
            return;
        }
        const auto edit = std::move(m_edit);
        edit->commit(PlaceCornersText::tr("Move a corner"));
    }

    void cancel() override { m_edit.reset(); }
    void show(ToolPicture& picture) const override { picture.cursor = Qt::SizeAllCursor; }

private:
    bool begin()
    {
        auto edit = m_context.state.document().beginEdit();
        if (!edit) {
            return false;
        }
        m_edit = std::move(edit).value();
        m_before = *m_context.state.scene().findPlace(m_hit.place);
        m_context.state.paths().select({m_hit.place});
        return true;
    }

    ToolContext m_context;
    ToolInput m_press;
    PlaceHit m_hit;
    model::Place m_before;
    std::unique_ptr<model::SceneEdit> m_edit;
};

/// After which corner another one comes: that of the side nearest to it.
std::size_t sideNear(const model::Place& place, const std::vector<glm::vec3>& corners,
                     const glm::vec3& point)
{
    std::size_t nearest = 0;
    float least = 1e9F;
    for (std::size_t i = 0; i < sidesOf(place); ++i) {
        const glm::vec3 from = corners[i];
        const glm::vec3 way = corners[(i + 1) % corners.size()] - from;
        const float off =
            glm::distance(point, from + way * model::nearestShare(point, from, from + way));
        if (off < least) {
            least = off;
            nearest = i;
        }
    }
    return nearest;
}

/// A line keeps two, an area three.
bool takeOut(model::Place& place, std::vector<glm::vec3>& corners, std::size_t corner)
{
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(corner));
    model::setCorners(place, corners);
    return model::isWhole(place);
}

} // namespace

DragSessionPtr cornerDrag(const ToolContext& context, const ToolInput& press, const PlaceHit& hit)
{
    return std::make_unique<CornerDrag>(context, press, hit);
}

bool changeCorners(const ToolContext& context, const ToolInput& input, const PlaceHit& hit)
{
    const model::Place* found = context.state.scene().findPlace(hit.place);
    const auto ground = groundUnder(context, input);
    if (found == nullptr || found->shape == model::PlaceShape::Round) {
        return false;
    }
    model::Place place = *found;
    std::vector<glm::vec3> corners = model::cornersOf(place);
    QString text;
    if (hit.corner) {
        text = PlaceCornersText::tr("Take out a corner");
        if (!takeOut(place, corners, *hit.corner)) {
            context.state.refuse(PlaceCornersText::tr("A line keeps two corners, an area three."));
            return true;
        }
    } else if (ground) {
        text = PlaceCornersText::tr("Insert a corner");
        const auto after = static_cast<std::ptrdiff_t>(sideNear(place, corners, *ground));
        corners.insert(corners.begin() + after + 1, *ground);
        model::setCorners(place, corners);
    }
    if (!text.isEmpty() && model::isWhole(place)) {
        context.state.document().edit(text,
                                      [&](model::SceneEdit& edit) { edit.changePlace(place); });
        context.state.paths().select({place.id});
    }
    return true;
}

} // namespace crowd::widgets
