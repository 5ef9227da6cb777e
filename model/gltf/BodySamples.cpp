// SPDX-License-Identifier: MIT
#include "model/gltf/BodySamples.h"

#include <algorithm>
#include <numeric>

#include "model/bake/Skinning.h"

namespace crowd::model::gltf {

namespace {

constexpr std::size_t kMaxSamples = 512;   ///< vertices looked at
constexpr std::size_t kMaxFeet = 4096;     ///< of the lowest ones
constexpr float kMomentsPerSecond = 48.0F; ///< poses looked at for foot contact
constexpr int kLeastMoments = 16;

} // namespace

Mesh excerpt(const Mesh& mesh, const std::vector<std::size_t>& vertices)
{
    const auto influences = static_cast<std::size_t>(mesh.influencesPerVertex);
    Mesh out;
    out.influencesPerVertex = mesh.influencesPerVertex;
    for (const std::size_t v : vertices) {
        out.positions.push_back(mesh.positions[v]);
        for (std::size_t i = 0; i < influences; ++i) {
            out.bones.push_back(mesh.bones[v * influences + i]);
            out.weights.push_back(mesh.weights[v * influences + i]);
        }
    }
    return out;
}

std::vector<glm::vec3> pointsAt(const Template& asset, const Mesh& mesh, int clip, float seconds,
                                Pose& pose)
{
    evaluatePose(asset, clip, seconds, pose);
    std::vector<glm::vec3> points(mesh.positions.size());
    skin(mesh, pose.bones, points, {});
    for (glm::vec3& point : points) {
        point = Bounds::isPlace(point) ? point : glm::vec3(0.0F);
    }
    return points;
}

Mesh evenExcerpt(const Mesh& mesh)
{
    std::vector<std::size_t> vertices;
    const std::size_t step = std::max<std::size_t>(1, mesh.positions.size() / kMaxSamples);
    for (std::size_t v = 0; v < mesh.positions.size(); v += step) {
        vertices.push_back(v);
    }
    return excerpt(mesh, vertices);
}

Mesh lowExcerpt(const Template& asset)
{
    const Mesh& mesh = asset.levels.front();
    Pose pose;
    const std::vector<glm::vec3> points = pointsAt(asset, mesh, asset.defaultClip, 0.0F, pose);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t kept =
        std::min(order.size(), std::clamp(order.size() / 16, kMaxSamples, kMaxFeet));
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                      [&](std::size_t a, std::size_t b) {
                          return points[a].y < points[b].y || (points[a].y == points[b].y && a < b);
                      });
    order.resize(kept);
    return excerpt(mesh, order);
}

std::vector<std::vector<glm::vec3>> pointsOver(const Template& asset, const Mesh& mesh, int clip,
                                               int moments, Pose& pose)
{
    const float step =
        asset.clips[static_cast<std::size_t>(clip)].seconds / static_cast<float>(moments);
    std::vector<std::vector<glm::vec3>> points;
    for (int i = 0; i <= moments; ++i) {
        points.push_back(pointsAt(asset, mesh, clip, step * static_cast<float>(i), pose));
    }
    return points;
}

int momentsOf(const Clip& clip)
{
    return std::clamp(static_cast<int>(clip.seconds * kMomentsPerSecond), kLeastMoments,
                      kMaxMoments);
}

double workOfAPose(const Template& asset)
{
    const std::size_t vertices =
        std::clamp(asset.levels.front().positions.size() / 16, kMaxSamples, kMaxFeet);
    double work = 0.0;
    for (const Clip& clip : asset.clips) {
        work += static_cast<double>(asset.nodes.size() + asset.bones.size() + clip.channels.size() +
                                    vertices);
    }
    return work;
}

} // namespace crowd::model::gltf
