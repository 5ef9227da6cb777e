// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "behavior/session/SessionPose.h"
#include "model/population/Population.h"

namespace crowd::behavior {

/// Some people as another run has them, everybody else as in a take: step by step, quickest in the
/// order of time. One thread.
class TakeComposition
{
public:
    /// `people`: of the scene, ascending, whom the other run has. `begin`: the step of the take at
    /// which it does. `scene`: whose seats count where a take says nothing of them.
    TakeComposition(std::vector<model::IndividualId> people, SessionPosePtr begin,
                    const model::Population& scene);

    /// At one time. `share`: 0 as in the other run, 1 where they are in the take, for those who are
    /// in both.
    [[nodiscard]] SessionPosePtr composed(const SessionPosePtr& take, const SessionPose& other,
                                          float share);
    /// A step of the take after the stretch: people fade from the clip that they had in `last`, the
    /// last step of the other run, to theirs.
    [[nodiscard]] SessionPosePtr fadedIn(const SessionPosePtr& take, const SessionPose& last) const;

private:
    [[nodiscard]] bool isMeant(model::IndividualId id) const;
    using Overrides = std::shared_ptr<const OverrideColumns>;
    /// What was put together last, and of what.
    struct Merged
    {
        Overrides take;
        Overrides other;
        Overrides merged;
        bool isThere = false;
    };
    [[nodiscard]] Overrides merged(const Overrides& take, const Overrides& other,
                                   const Overrides& begin) const;
    [[nodiscard]] Overrides remembered(Merged& last, const Overrides& take, const Overrides& other,
                                       const Overrides& begin) const;

    std::vector<model::IndividualId> m_people;
    SessionPosePtr m_begin;
    model::Population m_scene;
    Merged m_overrides;
    Merged m_recalled;
};

} // namespace crowd::behavior
