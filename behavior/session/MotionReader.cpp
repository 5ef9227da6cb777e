// SPDX-License-Identifier: MIT
#include "behavior/session/MotionReader.h"

#include <optional>
#include <span>
#include <vector>

#include "behavior/takes/PoseChecks.h"

namespace crowd::behavior {

SessionPosePtr MotionReader::read(std::uint64_t number)
{
    for (const Shown* shown : {&m_before, &m_last}) {
        if (shown->pose && shown->number == number) {
            return shown->pose;
        }
    }
    // On from the step that was read last, where that is on the way.
    const std::uint64_t from = m_last.pose ? m_last.number : number;
    PoseColumns columns = m_last.columns;
    const auto frames = m_cache->framesTo(number, from, m_loaded);
    for (const MotionCache::Frame& frame : frames) {
        const std::span bytes(frame.bytes.get(), frame.size);
        if (!columns.read(bytes, frame.isDifference)) {
            return nullptr;
        }
    }
    if (frames.empty()) {
        return nullptr;
    }
    auto pose = std::make_shared<SessionPose>(*frames.back().rest);
    columns.fill(*pose);
    if (m_cache->m_take && !isSound(*pose)) {
        return nullptr;
    }
    m_before = std::exchange(m_last, {number, std::move(columns), pose});
    return pose;
}

std::pair<SessionPosePtr, SessionPosePtr> MotionReader::around(double seconds)
{
    const std::optional<MotionCache::Found> found = m_cache->find(seconds);
    if (!found) {
        return {};
    }
    SessionPosePtr before = read(found->number);
    SessionPosePtr next = found->isLast ? before : read(found->number + 1);
    if (!before || !next) {
        m_cache->giveUp(before ? found->number + 1 : found->number);
        return {};
    }
    return {before, next};
}

} // namespace crowd::behavior
