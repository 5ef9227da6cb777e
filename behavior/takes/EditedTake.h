// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/agents/ClipPlace.h"
#include "behavior/session/MotionReader.h"
#include "behavior/takes/EditedTime.h"
#include "behavior/takes/SwappedPeople.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// A kept take as it is seen: its steps with what was done to people of it by hand. Who is held at
/// a moment stands (or sits on); what rules have set of people stays at its time. Quickest one step
/// after the other. One thread.
class EditedTake
{
public:
    /// `scene`: what people rest with; its takes are not asked for. Error: the motion is not there
    /// or cannot be read, or there are too many edits.
    [[nodiscard]] static model::Result<std::unique_ptr<EditedTake>> open(const model::Take& take,
                                                                         const model::Scene& scene);
    EditedTake(std::shared_ptr<MotionCache> motion, std::vector<model::HandEdit> edits,
               const model::Scene& scene);

    [[nodiscard]] const std::shared_ptr<MotionCache>& motion() const { return m_motion; }
    /// The scene's people, who may have been edited since it was opened.
    void setPeople(const model::Population& people);
    /// As MotionReader::around().
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr> around(double seconds);
    /// A step of the take as it is seen.
    [[nodiscard]] SessionPosePtr edited(const SessionPosePtr& pose);

private:
    /// Somebody with a time of his own.
    struct Person
    {
        model::IndividualId id = 0;
        std::optional<ClipPlace> rest; ///< what he stands with, at time 0
        double phase = 0.0;            ///< of what he rests with, so that not all do it alike
        bool isSeated = false;         ///< in the scene
    };
    /// People whose own time goes the same way.
    struct Group
    {
        std::vector<Person> people; ///< ascending ids
        EditedTime time;
        MotionReader reader;
    };
    /// People who go beside their way, or are hidden.
    struct Layer
    {
        model::HandEdit edit;
        std::vector<model::IndividualId> people; ///< ascending
        std::vector<glm::vec2> offsets;          ///< metres, one each; none: not known yet
    };

    /// People who are of other templates for a while.
    struct Swap
    {
        model::HandEdit edit;
        SwappedPeople people;
    };

    [[nodiscard]] bool isEdited() const
    {
        return !m_groups.empty() || !m_layers.empty() || !m_swaps.empty();
    }
    [[nodiscard]] SessionPosePtr withEverybody(const SessionPosePtr& pose) const;
    void gather(const std::vector<model::HandEdit>& edits, const model::Scene& scene);
    [[nodiscard]] model::HandEdit fromItsStep(model::HandEdit edit);
    [[nodiscard]] SessionPosePtr inOwnTime(const SessionPosePtr& pose);
    void findOffsets(Layer& layer);
    [[nodiscard]] float shareOf(const model::HandEdit& edit, double seconds) const;
    void apply(SessionPose& pose, Layer& layer);

    std::shared_ptr<MotionCache> m_motion;
    MotionReader m_reader;
    double m_first = 0.0;
    double m_last = 0.0;
    SessionPose m_scene; ///< those who are edited, as the scene has them
    std::vector<Group> m_groups;
    std::vector<Layer> m_layers;
    std::vector<Swap> m_swaps;
    /// What was made last, and of what.
    std::pair<SessionPosePtr, SessionPosePtr> m_from;
    std::pair<SessionPosePtr, SessionPosePtr> m_made;
};

} // namespace crowd::behavior
