// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/view/View.h"

namespace crowd::widgets {

/// A smooth way from one camera to another, so that the eye keeps its bearings. Positions follow
/// the turning pivot, so that an orbit looks like one. No clock of its own.
class CameraMotion
{
public:
    static constexpr double kSeconds = 0.3;

    void start(const model::Camera& from, const model::Camera& to, double seconds = kSeconds);
    void stop() { m_way.reset(); }
    [[nodiscard]] bool isMoving() const { return m_way.has_value(); }
    /// Where it leads; nothing while not moving.
    [[nodiscard]] std::optional<model::Camera> target() const;
    /// The camera after some more real seconds; the target itself, exactly, at the end.
    [[nodiscard]] model::Camera advance(double realSeconds);

private:
    struct Way
    {
        model::Camera from;
        model::Camera to;
        double length = kSeconds;
        double seconds = 0.0;
    };
    std::optional<Way> m_way;
};

} // namespace crowd::widgets
