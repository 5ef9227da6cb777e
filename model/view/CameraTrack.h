// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/scene/Scene.h"
#include "model/view/CameraWays.h"

namespace crowd::model {

/// Where a timeline's camera is at one moment.
struct DirectedCamera
{
    Camera camera;
    std::string name; ///< of the scene's camera that it stands at exactly; empty: of none
    LookId look = 0;  ///< of the camera that it went to, or began with, last; 0: none
    friend bool operator==(const DirectedCamera&, const DirectedCamera&) = default;
};

/// As it stands.
[[nodiscard]] DirectedCamera directed(const NamedCamera& camera);

/// Where the marks of a timeline move the camera. Before the first of them it is the scene's first
/// camera; each goes on from where the one before it has brought the camera by then. A plain value,
/// without the scene.
class CameraTrack
{
public:
    CameraTrack() = default; ///< without moves, as all the next one says
    explicit CameraTrack(DirectedCamera start) : m_start(std::move(start)) {}
    explicit CameraTrack(const Scene& scene);
    /// Once around what a camera looks at, at an even speed, from a moment on. Seconds.
    [[nodiscard]] static CameraTrack turntable(DirectedCamera start, double begin, double length);

    [[nodiscard]] bool hasMoves() const { return !m_legs.empty(); }
    /// Seconds of the clock.
    [[nodiscard]] DirectedCamera at(double seconds) const;
    /// From when to when it moves by one mark, seconds: until the next one takes over. A cut ends
    /// as it begins.
    struct Move
    {
        double begin = 0.0;
        double end = 0.0;
    };
    [[nodiscard]] std::vector<Move> moves() const;
    /// Where it was at an earlier moment, but not before the move that is under way now has begun:
    /// what moves in a picture does not jump with a cut.
    [[nodiscard]] DirectedCamera before(double earlier, double now) const;

private:
    struct Leg
    {
        Mark mark;
        DirectedCamera from; ///< where it goes on from
        DirectedCamera base; ///< To: where it goes; else what the move begins with
        std::shared_ptr<const CameraRail> rail; ///< Along; null: it stays
    };
    /// That some of the moves travel along, on the ground: one each, however many do.
    using Rails = std::map<PathId, std::shared_ptr<const CameraRail>>;
    void add(const Mark& mark, const Scene& scene, Rails& rails);
    [[nodiscard]] const Leg* legAt(double seconds) const; ///< null: before the first
    [[nodiscard]] static DirectedCamera on(const Leg& leg, double seconds);

    DirectedCamera m_start;
    std::vector<Leg> m_legs; ///< in the order in which they happen
};

} // namespace crowd::model
