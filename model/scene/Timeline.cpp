// SPDX-License-Identifier: MIT
#include "model/scene/Timeline.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace crowd::model {

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

bool doesAnything(const Timeline& timeline)
{
    return std::ranges::any_of(timeline,
                               [](const Mark& mark) { return mark.kind != MarkKind::Marker; });
}

} // namespace crowd::model
