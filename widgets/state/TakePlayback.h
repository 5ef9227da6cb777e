// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "behavior/session/MotionReader.h"
#include "model/base/Result.h"
#include "model/scene/Take.h"

namespace crowd::widgets {

/// A kept take that is shown instead of a run. Main thread.
class TakePlayback
{
public:
    [[nodiscard]] static model::Result<std::unique_ptr<TakePlayback>> open(const model::Take& take);

    /// Whether it is that take, whatever it is called.
    [[nodiscard]] bool shows(const model::Take& take) const;
    [[nodiscard]] model::TakeId id() const { return m_id; }
    [[nodiscard]] double first() const { return m_extent.first; } ///< seconds of the clock
    [[nodiscard]] double last() const { return m_extent.last; }
    /// For readers on any thread.
    [[nodiscard]] const std::shared_ptr<behavior::MotionCache>& motion() const { return m_motion; }
    /// Of the step that is shown at a time; null: it cannot be read any more.
    [[nodiscard]] behavior::SessionPosePtr poseAt(double seconds) const;
    /// Puts people where they are at frame.seconds, before its beginning and after its end as they
    /// are there. False: it cannot be read any more, and they are as the scene has them.
    bool pose(model::CrowdFrame& frame) const;

private:
    TakePlayback(const model::Take& take, std::shared_ptr<behavior::MotionCache> motion);

    model::TakeId m_id;
    model::MotionFilePtr m_file;
    std::shared_ptr<behavior::MotionCache> m_motion;
    behavior::MotionCache::Extent m_extent;
    mutable behavior::MotionReader m_reader;
};

} // namespace crowd::widgets
