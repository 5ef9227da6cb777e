// SPDX-License-Identifier: MIT
#include "model/scene/NearestPath.h"

#include <limits>

#include <glm/common.hpp>
#include <glm/gtx/norm.hpp>

#include "model/base/Segment.h"
#include "model/scene/Scene.h"

namespace crowd::model {

namespace {

std::vector<glm::vec3> pointsOf(const Scene& scene, const Path& path)
{
    std::vector<glm::vec3> points;
    for (const PlaceId id : path.places) {
        if (const Place* place = scene.findPlace(id)) {
            points.push_back(place->position);
        }
    }
    if (path.kind == PathKind::Cyclic && points.size() > 2) {
        points.push_back(points.front());
    }
    return points;
}

} // namespace

NearestPath::NearestPath(const Scene& scene)
{
    for (const Path& path : scene.paths) {
        const std::vector<glm::vec3> points = pointsOf(scene, path);
        for (std::size_t i = 1; i < points.size(); ++i) {
            m_legs.push_back({path.id, points[i - 1], points[i]});
        }
        if (points.size() == 1) {
            m_legs.push_back({path.id, points.front(), points.front()});
        }
    }
}

PathId NearestPath::at(const glm::vec3& position) const
{
    PathId nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (const Leg& leg : m_legs) {
        const float share = nearestShare(position, leg.from, leg.to);
        const float distance2 = glm::distance2(position, glm::mix(leg.from, leg.to, share));
        if (distance2 < least) {
            least = distance2;
            nearest = leg.path;
        }
    }
    return nearest;
}

} // namespace crowd::model
