// SPDX-License-Identifier: MIT
#include "model/scene/Timeline.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace crowd::model {

namespace {

double secondsOf(int milliseconds)
{
    return static_cast<double>(milliseconds) / 1000.0;
}

} // namespace

void Mark::setTiming(const RecallTiming& timing)
{
    fade = timing.seconds;
    spread = timing.stagger.seconds;
    order = timing.stagger.order;
    point = timing.stagger.point;
    headingRadians = timing.stagger.headingRadians;
}

const Mark* findMark(const Timeline& timeline, MarkId id)
{
    const auto found = std::ranges::lower_bound(timeline, id, {}, &Mark::id);
    return found == timeline.end() || found->id != id ? nullptr : &*found;
}

MarkId freeMarkId(const Timeline& timeline)
{
    const MarkId last = timeline.empty() ? 0 : timeline.back().id;
    const bool isFull = timeline.size() >= kMostMarks || last == std::numeric_limits<MarkId>::max();
    return isFull ? 0 : last + 1;
}

Timeline inOrder(Timeline timeline)
{
    std::ranges::sort(timeline, [](const Mark& a, const Mark& b) {
        return std::tie(a.seconds, a.id) < std::tie(b.seconds, b.id);
    });
    return timeline;
}

double Mark::length() const
{
    double length = 0.0;
    if (kind == MarkKind::State) {
        length = static_cast<double>(fade + spread);
    } else if (kind == MarkKind::Event && !delays.empty()) {
        length = secondsOf(std::ranges::max(delays));
    } else if (kind == MarkKind::Camera) {
        length = static_cast<double>(travel);
    }
    return length;
}

Timeline atOneMomentEach(const Mark& mark)
{
    if (mark.kind != MarkKind::Event || mark.delays.empty() || mark.people.empty()) {
        return {mark};
    }
    std::map<int, std::vector<int>> heard; // by how much later
    for (std::size_t i = 0; i < mark.people.size(); ++i) {
        heard[i < mark.delays.size() ? mark.delays[i] : 0].push_back(mark.people[i]);
    }
    Timeline parts;
    for (auto& [delay, people] : heard) {
        Mark& part = parts.emplace_back(mark);
        part.seconds += secondsOf(delay);
        part.people = std::move(people);
        part.delays.clear();
    }
    return parts;
}

bool doesAnything(const Timeline& timeline)
{
    return std::ranges::any_of(timeline, [](const Mark& mark) { return isForPeople(mark.kind); });
}

} // namespace crowd::model
