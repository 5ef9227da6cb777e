// SPDX-License-Identifier: MIT
#include "widgets/viewport/CameraMarks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace crowd::widgets {

namespace {

constexpr std::size_t kMostMoves = 100; ///< that are drawn: the first
constexpr int kPieces = 48;             ///< of a way
constexpr float kLeastStep = 1e-3F;     ///< metres: it stands
constexpr glm::vec4 kWay{0.61F, 0.42F, 0.87F, 0.85F};
constexpr glm::vec4 kPlace{0.61F, 0.42F, 0.87F, 0.6F};
constexpr glm::vec4 kNow{0.96F, 0.86F, 1.0F, 1.0F};
constexpr float kCameraShare = 0.03F; ///< size of a camera, of the distance from the view's
constexpr float kNowShare = 0.05F;

float distanceFrom(const model::Camera& view, const glm::vec3& point)
{
    return view.projection == model::Projection::Perspective
               ? std::max(glm::distance(view.position, point), 0.1F)
               : view.orthographicHeight;
}

} // namespace

void CameraMarks::addWay(const model::CameraTrack& track, const model::CameraTrack::Move& move)
{
    glm::vec3 last = track.at(move.begin).camera.position;
    for (int i = 1; i <= kPieces; ++i) {
        const double share = static_cast<double>(i) / kPieces;
        const double seconds = move.begin + (move.end - move.begin) * share;
        const glm::vec3 next = track.at(seconds).camera.position;
        if (glm::distance(last, next) > kLeastStep) {
            const bool isEnd = i == kPieces;
            m_lines.push_back({last, next, kWay, isEnd ? 7.0F : 2.5F, isEnd ? 0.0F : 2.5F});
            last = next;
        }
    }
}

/// A pyramid that opens towards what it sees.
void CameraMarks::addCamera(const model::Camera& camera, float metres, const glm::vec4& color)
{
    const float half = metres * std::min(std::tan(camera.fovYRadians * 0.5F), 1.5F);
    const glm::vec3 middle = camera.position + metres * camera.forward();
    const glm::vec3 right = camera.right() * half * 1.6F;
    const glm::vec3 up = camera.up() * half;
    const std::array corners{middle - right - up, middle + right - up, middle + right + up,
                             middle - right + up};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        m_lines.push_back({camera.position, corners[i], color, 1.5F, 1.5F});
        m_lines.push_back({corners[i], corners[(i + 1) % corners.size()], color, 1.5F, 1.5F});
    }
    m_lines.push_back({corners[3], middle + up * 1.5F, color, 1.5F, 1.5F}); // which side is up
    m_lines.push_back({middle + up * 1.5F, corners[2], color, 1.5F, 1.5F});
}

void CameraMarks::make(EditorState& state)
{
    m_lines.clear();
    const model::CameraTrack& track = state.director().track();
    if (state.director().isOn() || !track.hasMoves() || !state.viewOptions().showPaths) {
        return;
    }
    const model::Camera& view = state.camera();
    std::size_t drawn = 0;
    for (const model::CameraTrack::Move& move : track.moves()) {
        if (++drawn > kMostMoves) {
            break;
        }
        addWay(track, move);
        const model::Camera end = track.at(move.end).camera;
        addCamera(end, kCameraShare * distanceFrom(view, end.position), kPlace);
    }
    const model::Camera now = track.at(state.transport().seconds()).camera;
    addCamera(now, kNowShare * distanceFrom(view, now.position), kNow);
}

} // namespace crowd::widgets
