// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "behavior/session/MotionCache.h"

namespace crowd::behavior {

/// Reads the steps of a run, also while more are added; quickest one after the other. One thread.
class MotionReader
{
public:
    explicit MotionReader(std::shared_ptr<MotionCache> cache) : m_cache(std::move(cache)) {}

    [[nodiscard]] const MotionCache& cache() const { return *m_cache; }
    /// The last step that is not later, and the one after it (the same one at the end); the
    /// earliest where all are later. Null where there is none, or where what was kept is damaged:
    /// then that and all before it is given up.
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> around(double seconds);

private:
    /// A step that was read.
    struct Shown
    {
        std::uint64_t number = 0; ///< since the run began
        PoseColumns columns;
        SessionPosePtr pose; ///< null: none
    };

    [[nodiscard]] SessionPosePtr read(std::uint64_t number);

    std::shared_ptr<MotionCache> m_cache;
    Shown m_before; ///< the step read last but one
    Shown m_last;
    MotionCache::Loaded m_loaded;
};

} // namespace crowd::behavior
