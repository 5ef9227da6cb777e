// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/base/Bounds.h"
#include "model/describe/Field.h"

namespace crowd::model {

enum class Projection : unsigned char { Perspective, Orthographic };

/// Where a picture is taken from. World frame, metres; looks along -Z of its orientation, Y up.
struct Camera
{
    glm::vec3 position{0.0F, 4.0F, 12.0F};
    glm::quat orientation{1.0F, 0.0F, 0.0F, 0.0F};
    Projection projection = Projection::Perspective;
    float fovYRadians = 0.8F;         ///< perspective: full vertical angle
    float orthographicHeight = 20.0F; ///< orthographic: metres from bottom to top
    float pivotDistance = 12.0F;      ///< to the point that orbiting turns around

    [[nodiscard]] glm::vec3 forward() const;
    [[nodiscard]] glm::vec3 up() const;
    [[nodiscard]] glm::vec3 right() const;
    [[nodiscard]] glm::vec3 pivot() const;
    [[nodiscard]] static Camera lookingAt(const glm::vec3& from, const glm::vec3& at);

    static constexpr auto fields();
    friend bool operator==(const Camera&, const Camera&) = default;
};

constexpr auto Camera::fields()
{
    using S = Camera;
    using C = FieldContext;
    // Metres: as far as scripts can place it, and all that it sees from there.
    constexpr double kFarthest = 1e9;
    constexpr double kNearest = 1e-9;
    constexpr double kLargest = 1e12;
    constexpr auto isParallel = [](const S& s, const C&) {
        return s.projection == Projection::Orthographic;
    };
    constexpr auto hasAngle = [](const S& s, const C&) {
        return s.projection == Projection::Perspective;
    };
    return std::tuple(
        field(&S::position,
              {.key = "position", .doc = "where it stands", .low = -kFarthest, .high = kFarthest}),
        field(&S::orientation,
              {.key = "orientation", .doc = "a quaternion: it looks along -Z, with Y up"}),
        stored<S, bool>([](const S& s) { return s.projection == Projection::Orthographic; },
                        [](S& s, bool is) {
                            s.projection = is ? Projection::Orthographic : Projection::Perspective;
                        },
                        {.key = "orthographic",
                         .label = QT_TRANSLATE_NOOP("Fields", "Parallel"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "Without perspective, as in a plan"),
                         .doc = "without perspective"}),
        field(&S::fovYRadians,
              {.key = "fovY",
               .label = QT_TRANSLATE_NOOP("Fields", "Angle of View"),
               .tip = QT_TRANSLATE_NOOP("Fields", "From the picture's lower edge to its upper one. "
                                                  "Small: as through a long lens; large: a wide "
                                                  "one"),
               .doc = "from the lower edge to the upper one, perspective",
               .unit = QT_TRANSLATE_NOOP("Fields", "°"),
               .low = 0.01,
               .high = 3.1,
               .sliderLow = 5.0,
               .sliderHigh = 120.0,
               .step = 1.0,
               .decimals = 1,
               .shownScale = 57.29577951308232})
            .when(hasAngle),
        field(&S::orthographicHeight,
              {.key = "orthographicHeight",
               .label = QT_TRANSLATE_NOOP("Fields", "Height"),
               .tip = QT_TRANSLATE_NOOP("Fields", "What the picture shows from its lower edge to "
                                                  "its upper one"),
               .doc = "metres from bottom to top, orthographic",
               .unit = QT_TRANSLATE_NOOP("Fields", " m"),
               .low = kNearest,
               .high = kLargest,
               .sliderLow = 1.0,
               .sliderHigh = 500.0,
               .step = 0.1,
               .decimals = 1,
               .isLogarithmic = true})
            .when(isParallel),
        field(&S::pivotDistance, {.key = "pivotDistance",
                                  .doc = "metres to the point that orbiting turns around",
                                  .low = kNearest,
                                  .high = kLargest}));
}

struct Ray
{
    glm::vec3 origin{0.0F};
    glm::vec3 direction{0.0F, 0.0F, -1.0F}; ///< unit
};

/// A camera with the size of the picture in logical pixels (y down, origin top left), or with a
/// part of it: what turns world into screen and back. The one place where projections are computed.
class View
{
public:
    View(const Camera& camera, glm::vec2 sizePixels);

    /// A part of this picture, as a picture by itself: what is at `corner` here is at its origin,
    /// and as large as here. Not of a part.
    [[nodiscard]] View part(glm::vec2 corner, glm::vec2 sizePixels) const;
    /// What this one is a part of; else the same.
    [[nodiscard]] View whole() const { return {m_camera, m_wholeSize}; }

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    [[nodiscard]] glm::vec2 size() const { return m_size; }
    /// Where a part begins in its whole.
    [[nodiscard]] glm::vec2 corner() const { return m_corner; }
    [[nodiscard]] float nearPlane() const { return m_near; }
    [[nodiscard]] const glm::mat4& viewMatrix() const { return m_view; }
    [[nodiscard]] const glm::mat4& projectionMatrix() const
    {
        return m_projection;
    } ///< GL clip space
    [[nodiscard]] const glm::mat4& viewProjection() const { return m_viewProjection; }
    /// Screen position in logical pixels and depth in metres along the view axis; nothing when the
    /// point is behind the near plane.
    [[nodiscard]] std::optional<glm::vec3> project(const glm::vec3& world) const;
    [[nodiscard]] Ray rayThrough(glm::vec2 pixel) const;
    /// Logical pixels that one metre takes at a depth.
    [[nodiscard]] float pixelsPerMetre(float depth) const;

private:
    Camera m_camera;
    glm::vec2 m_size;
    glm::vec2 m_wholeSize;
    glm::vec2 m_corner{0.0F};
    float m_near;
    glm::mat4 m_view;
    glm::mat4 m_projection;
    glm::mat4 m_viewProjection;
};

} // namespace crowd::model
