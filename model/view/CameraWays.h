// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "model/view/View.h"

/// Ways that cameras take. World frame, metres, radians.
namespace crowd::model {

/// Between two cameras, t 0..1. Positions follow the turning pivot, so that an orbit looks like
/// one. Exactly `to` at 1.
[[nodiscard]] Camera blended(const Camera& from, const Camera& to, float t);

/// Gone around its pivot, upright; positive: to the right around it, seen from the camera.
[[nodiscard]] Camera goneAround(const Camera& camera, float radians);

/// A smooth way through points, at an even speed: a cubic Hermite curve through them, whose
/// tangents weigh the neighbouring chords by their lengths (Catmull-Rom over chord lengths).
class CameraRail
{
public:
    /// Points that follow each other in the same place count once.
    CameraRail(const std::vector<glm::vec3>& points, bool isClosed);

    /// There are not two points apart: it leads nowhere.
    [[nodiscard]] bool isEmpty() const { return m_points.size() < 2; }
    [[nodiscard]] double length() const { return m_lengths.empty() ? 0.0 : m_lengths.back(); }
    struct Spot
    {
        glm::vec3 position{0.0F};
        glm::vec3 direction{0.0F, 0.0F, -1.0F}; ///< unit, along the way
    };
    /// Share of its length, 0..1. Only where it is not empty.
    [[nodiscard]] Spot at(float share) const;

private:
    static constexpr int kSamples = 32; ///< of each piece between two points

    [[nodiscard]] std::size_t pieces() const;
    [[nodiscard]] glm::vec3 point(std::ptrdiff_t index) const;
    [[nodiscard]] glm::vec3 tangent(std::size_t index) const;
    [[nodiscard]] glm::vec3 onPiece(std::size_t piece, float t) const;
    void measure();

    std::vector<glm::vec3> m_points;
    bool m_isClosed = false;
    std::vector<double> m_lengths; ///< along the way up to each sample; the first is 0
};

struct RailPlace
{
    float share = 0.0F;     ///< of its length, 0..1
    float above = 0.0F;     ///< metres
    bool looksAhead = true; ///< else at what the camera looks at
};
/// Above a rail. Where there is nothing to look at the camera's direction stays.
[[nodiscard]] Camera onRail(const Camera& camera, const CameraRail& rail, const RailPlace& place);

} // namespace crowd::model
