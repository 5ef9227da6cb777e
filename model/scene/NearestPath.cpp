// SPDX-License-Identifier: MIT
#include "model/scene/NearestPath.h"

#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/norm.hpp>

#include "model/scene/Scene.h"

namespace crowd::model {

namespace {

float squaredDistance(const glm::vec3& point, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 along = to - from;
    const float length2 = glm::length2(along);
    const float share =
        length2 > 0.0F ? glm::clamp(glm::dot(point - from, along) / length2, 0.0F, 1.0F) : 0.0F;
    return glm::distance2(point, from + along * share);
}

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
        const float distance = squaredDistance(position, leg.from, leg.to);
        if (distance < least) {
            least = distance;
            nearest = leg.path;
        }
    }
    return nearest;
}

} // namespace crowd::model
