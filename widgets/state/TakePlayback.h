// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "behavior/session/MotionCache.h"
#include "behavior/session/SessionPose.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "model/scene/Take.h"

namespace crowd::behavior {
class EditedTake;
} // namespace crowd::behavior

namespace crowd::widgets {

/// A kept take that is shown instead of a run. Main thread.
class TakePlayback
{
public:
    /// `scene`: whose people they are.
    [[nodiscard]] static model::Result<std::unique_ptr<TakePlayback>>
    open(const model::Take& take, const model::Scene& scene);

    ~TakePlayback();
    TakePlayback(const TakePlayback&) = delete;
    TakePlayback& operator=(const TakePlayback&) = delete;

    /// Whether it is that take with those edits, whatever it is called.
    [[nodiscard]] bool shows(const model::Take& take) const;
    [[nodiscard]] model::TakeId id() const { return m_id; }
    [[nodiscard]] double first() const { return m_extent.first; } ///< seconds of the clock
    [[nodiscard]] double last() const { return m_extent.last; }
    /// As it was kept, without edits; for readers on any thread.
    [[nodiscard]] const std::shared_ptr<behavior::MotionCache>& motion() const;
    /// Of the step that is shown at a time; null: it cannot be read any more.
    [[nodiscard]] behavior::SessionPosePtr poseAt(double seconds) const;
    /// Puts people where they are at frame.seconds, before its beginning and after its end as they
    /// are there. False: it cannot be read any more, and they are as the scene has them.
    bool pose(model::CrowdFrame& frame) const;

private:
    TakePlayback(const model::Take& take, std::unique_ptr<behavior::EditedTake> edited);

    model::TakeId m_id;
    model::MotionFilePtr m_file;
    std::vector<model::HandEdit> m_edits;
    bool m_areEditsOn;
    std::unique_ptr<behavior::EditedTake> m_edited; ///< read by functions that change nothing else
    behavior::MotionCache::Extent m_extent;
};

} // namespace crowd::widgets
