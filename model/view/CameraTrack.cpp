// SPDX-License-Identifier: MIT
#include "model/view/CameraTrack.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace crowd::model {

namespace {

constexpr double kSameMoment = 1e-6; ///< seconds; a frame's time is a sum

/// Null: it leads nowhere.
std::shared_ptr<const CameraRail> railOf(const Scene& scene, PathId id)
{
    const auto path = std::ranges::find(scene.paths, id, &Path::id);
    if (path == scene.paths.end()) {
        return nullptr;
    }
    std::vector<glm::vec3> points;
    for (const PlaceId each : path->places) {
        if (const Place* place = scene.findPlace(each)) {
            points.push_back(place->position);
        }
    }
    auto rail = std::make_shared<const CameraRail>(points, path->kind == PathKind::Cyclic);
    return rail->isEmpty() ? nullptr : rail;
}

/// 0..1; slow at both ends where it is gentle.
float shareOf(const Mark& mark, double seconds)
{
    if (mark.travel <= 0.0F) {
        return 1.0F;
    }
    const double gone = (seconds - mark.seconds) / static_cast<double>(mark.travel);
    const auto t = static_cast<float>(std::clamp(gone, 0.0, 1.0));
    return mark.isGentle ? t * t * (3.0F - 2.0F * t) : t;
}

} // namespace

DirectedCamera directed(const NamedCamera& camera)
{
    return {camera.camera, camera.name, camera.look};
}

CameraTrack::CameraTrack(const Scene& scene)
{
    if (!scene.cameras.empty()) {
        m_start = directed(scene.cameras.front());
    }
    Timeline moves;
    std::ranges::copy_if(scene.timeline, std::back_inserter(moves),
                         [](const Mark& mark) { return mark.kind == MarkKind::Camera; });
    Rails rails;
    for (const Mark& mark : inOrder(std::move(moves))) {
        add(mark, scene, rails);
    }
}

CameraTrack CameraTrack::turntable(DirectedCamera start, double begin, double length)
{
    Mark mark;
    mark.kind = MarkKind::Camera;
    mark.move = CameraMove::Around;
    mark.seconds = begin;
    mark.travel = static_cast<float>(length);
    mark.isGentle = false;
    CameraTrack track(std::move(start));
    Rails none;
    track.add(mark, Scene(), none);
    return track;
}

/// Later than those that are there.
void CameraTrack::add(const Mark& mark, const Scene& scene, Rails& rails)
{
    Leg leg;
    leg.mark = mark;
    leg.from = at(mark.seconds);
    const auto named = std::ranges::find(scene.cameras, mark.camera, &NamedCamera::name);
    leg.base = !mark.camera.empty() && named != scene.cameras.end() ? directed(*named) : leg.from;
    if (mark.move == CameraMove::Along) {
        const auto [rail, isNew] = rails.try_emplace(mark.path);
        if (isNew) {
            rail->second = railOf(scene, mark.path);
        }
        leg.rail = rail->second;
    }
    m_legs.push_back(std::move(leg));
}

DirectedCamera CameraTrack::on(const Leg& leg, double seconds)
{
    const float share = shareOf(leg.mark, seconds);
    DirectedCamera now = leg.base;
    if (leg.mark.move == CameraMove::Around) {
        now.camera = goneAround(leg.base.camera, leg.mark.turn * share);
    } else if (leg.mark.move == CameraMove::To) {
        now.camera = blended(leg.from.camera, leg.base.camera, share);
    } else if (leg.rail) {
        now.camera =
            onRail(leg.base.camera, *leg.rail, {share, leg.mark.above, leg.mark.looksAhead});
    }
    if (now.camera != leg.base.camera) {
        now.name.clear();
    }
    return now;
}

const CameraTrack::Leg* CameraTrack::legAt(double seconds) const
{
    const auto next = std::ranges::upper_bound(m_legs, seconds + kSameMoment, {},
                                               [](const Leg& leg) { return leg.mark.seconds; });
    return next == m_legs.begin() ? nullptr : &*std::prev(next);
}

DirectedCamera CameraTrack::at(double seconds) const
{
    const Leg* leg = legAt(seconds);
    return leg == nullptr ? m_start : on(*leg, seconds);
}

std::vector<CameraTrack::Move> CameraTrack::moves() const
{
    std::vector<Move> all;
    for (std::size_t i = 0; i < m_legs.size(); ++i) {
        const Mark& mark = m_legs[i].mark;
        Move move{mark.seconds, mark.seconds + mark.length()};
        if (i + 1 < m_legs.size()) { // the very moment of the next one is that one's already
            const double next = m_legs[i + 1].mark.seconds - 2.0 * kSameMoment;
            move.end = std::clamp(move.end, move.begin, std::max(next, move.begin));
        }
        all.push_back(move);
    }
    return all;
}

DirectedCamera CameraTrack::before(double earlier, double now) const
{
    const Leg* leg = legAt(now);
    return leg == nullptr ? m_start : on(*leg, std::max(earlier, leg->mark.seconds));
}

} // namespace crowd::model
