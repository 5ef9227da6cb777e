// SPDX-License-Identifier: MIT
#include "widgets/state/TakePlayback.h"

#include <utility>

#include "behavior/takes/EditedTake.h"

namespace crowd::widgets {

TakePlayback::TakePlayback(const model::Take& take, std::unique_ptr<behavior::EditedTake> edited)
    : m_id(take.id), m_file(take.motion), m_edits(take.edits), m_areEditsOn(take.areEditsOn),
      m_edited(std::move(edited)), m_extent(m_edited->motion()->extent())
{
}

model::Result<std::unique_ptr<TakePlayback>> TakePlayback::open(const model::Take& take,
                                                                const model::Scene& scene)
{
    auto edited = behavior::EditedTake::open(take, scene);
    if (!edited) {
        return edited.error();
    }
    return std::unique_ptr<TakePlayback>(new TakePlayback(take, std::move(edited).value()));
}

TakePlayback::~TakePlayback() = default;

const std::shared_ptr<behavior::MotionCache>& TakePlayback::motion() const
{
    return m_edited->motion();
}

bool TakePlayback::shows(const model::Take& take) const
{
    return take.id == m_id && take.motion == m_file && take.areEditsOn == m_areEditsOn &&
           take.edits == m_edits;
}

behavior::SessionPosePtr TakePlayback::poseAt(double seconds) const
{
    return m_edited->around(seconds).first;
}

bool TakePlayback::pose(model::CrowdFrame& frame) const
{
    m_edited->setPeople(frame.population);
    const auto [before, after] = m_edited->around(frame.seconds);
    if (!before) {
        return false;
    }
    behavior::applyPose(*before, *after, frame);
    return true;
}

} // namespace crowd::widgets
