// SPDX-License-Identifier: MIT
#include "widgets/state/TakePlayback.h"

#include <utility>

#include "behavior/takes/TakeFile.h"

namespace crowd::widgets {

TakePlayback::TakePlayback(const model::Take& take, std::shared_ptr<behavior::MotionCache> motion)
    : m_id(take.id), m_file(take.motion), m_motion(std::move(motion)), m_extent(m_motion->extent()),
      m_reader(m_motion)
{
}

model::Result<std::unique_ptr<TakePlayback>> TakePlayback::open(const model::Take& take)
{
    if (!take.motion) {
        return model::Error{take.problem};
    }
    auto motion = behavior::openTake(take.motion);
    if (!motion) {
        return motion.error();
    }
    return std::unique_ptr<TakePlayback>(new TakePlayback(take, std::move(motion).value()));
}

bool TakePlayback::shows(const model::Take& take) const
{
    return take.id == m_id && take.motion == m_file;
}

behavior::SessionPosePtr TakePlayback::poseAt(double seconds) const
{
    return m_reader.around(seconds).first;
}

bool TakePlayback::pose(model::CrowdFrame& frame) const
{
    const auto [before, after] = m_reader.around(frame.seconds);
    if (!before) {
        return false;
    }
    behavior::applyPose(*before, *after, frame);
    return true;
}

} // namespace crowd::widgets
