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

constexpr double kCornerPixels = 8.0;
constexpr double kSidePixels = 5.0;
constexpr double kCornerSlack = 4.0;

std::size_t sidesOf(const model::Place& place)
{
    return place.shape == model::PlaceShape::Area ? place.corners.size() : place.corners.size() - 1;
}

/// How wide a line is where it begins, from its middle, pixels.
double halfPixels(const model::View& view, const model::Place& place, const glm::vec3& corner)
{
    const auto middle = view.project(corner);
    const auto aside = view.project(corner + glm::vec3(place.radius, 0.0F, 0.0F));
    return middle && aside && place.shape == model::PlaceShape::Line
               ? QLineF(QPointF(middle->x, middle->y), QPointF(aside->x, aside->y)).length()
               : 0.0;
}

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

double distanceToSide(const QPointF& pixel, const QPointF& from, const QPointF& to)
{
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(pixel - from, along) / square, 0.0, 1.0)
                     : 0.0;
    return QLineF(pixel, from + along * share).length();
}

std::optional<PlaceHit> shapeAt(const model::View& view, const model::Place& place,
                                const QPointF& pixel)
{
    if (place.shape == model::PlaceShape::Round) {
        return std::nullopt;
    }
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    std::vector<std::optional<QPointF>> pixels;
    pixels.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        const auto at = view.project(corner);
        pixels.push_back(at ? std::optional(QPointF(at->x, at->y)) : std::nullopt);
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] && QLineF(pixel, *pixels[i]).length() < kCornerPixels) {
            return PlaceHit{place.id, false, i};
        }
    }
    for (std::size_t i = 0; i < sidesOf(place); ++i) {
        const auto& from = pixels[i];
        const auto& to = pixels[(i + 1) % pixels.size()];
        if (from && to &&
            distanceToSide(pixel, *from, *to) <
                std::max(kSidePixels, halfPixels(view, place, corners[i]))) {
            return PlaceHit{place.id, false, std::nullopt};
        }
    }
    return std::nullopt;
}

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
            context.state.showStatus(
                PlaceCornersText::tr("A line keeps two corners, an area three."));
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
