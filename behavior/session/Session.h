// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/rules/RuleEngine.h"
#include "behavior/session/SessionPlan.h"
#include "behavior/session/SessionPose.h"
#include "behavior/session/SessionTally.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "model/states/StateKeeping.h"

namespace crowd::behavior {

struct SessionParts;
class SessionRules;

/// One run of the simulation. Starts from the scene, keeps columns of its own and never writes to
/// the scene. Whoever does not walk is an obstacle that stays. Steps are as long as the scene said
/// when the session began; the same scene, plan, edits and number of steps give the same bits. One
/// thread at a time; frames and poses may be read on any. What it does is done by its parts: see
/// SessionParts.h.
class Session
{
public:
    Session(const model::Scene& scene, const SessionPlan& plan);
    explicit Session(const model::Scene& scene) : Session(scene, SessionPlan::of(scene)) {}
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void step();
    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] double seconds() const;
    [[nodiscard]] std::uint32_t stepsPerSecond() const;
    /// The transport's time at the beginning: only where clips stand depends on it.
    void setStart(double seconds);

    /// Before the first step: people are on the move, as they were from one pose of a run to its
    /// next. Who is in neither begins at rest.
    void beginAs(const SessionPose& before, const SessionPose& now);
    /// The same, and people are where and as they were there, whatever the scene says; rules begin
    /// anew. The start is set to that moment.
    void beginFrom(const SessionPose& before, const SessionPose& now);
    /// Called in each step, when people know where they would like to go and have not gone yet.
    using Steering = std::function<void(CrowdSimulation& crowd)>;
    void setSteering(Steering steering) { m_steering = std::move(steering); }

    /// The scene was edited: what is another there now is another here from the next step on,
    /// everything else goes on as it is. After poses were kept, where people are in the scene is
    /// where they are here.
    void adopt(const model::Scene& scene, bool arePosesKept = false);
    /// The same after a state was recalled: people are seen to change over to what is new.
    void adopt(const model::Scene& scene, const model::ChangeOver& change);
    /// People take on a state of the scene in this session alone, until the scene is edited where
    /// they do. What did not fit is also among the warnings.
    model::StateRecall recall(const model::ChangeOver& change);
    /// What there is to walk on, and its walls; null: open ground.
    void setSurface(std::shared_ptr<const WalkSurface> surface);
    /// An event happens to these people at the next step.
    void send(const std::string& event, float payload, const std::vector<model::IndividualId>& ids);
    /// To those who have a tag in this session.
    void sendTagged(const std::string& event, float payload, std::uint8_t tag);
    /// What happens at a mark happens now, at the next step, whenever the mark is; the scene's mark
    /// of that id does not do it again. The timeline's own marks do it by themselves.
    void perform(const model::Mark& mark);

    /// Those whom the session moves, as of the last step.
    [[nodiscard]] SessionPosePtr pose() const;
    /// Everybody as of the last step, for the renderer.
    [[nodiscard]] model::CrowdFramePtr frame() const;
    /// The path that each follows now, by row of the frame: also a branch's, or one of a rule's
    /// action. 0: none, or he has left.
    [[nodiscard]] std::vector<model::PathId> paths() const;
    /// People counted, as of the last step.
    [[nodiscard]] SessionTally tally() const;
    /// What in the plan could not be followed, or came to grief.
    [[nodiscard]] const std::vector<Problem>& warnings() const;
    /// Those, and what went wrong with rules.
    [[nodiscard]] std::vector<Problem> problems() const;
    [[nodiscard]] RuleEngine& rules();

    /// For measuring and tuning.
    [[nodiscard]] CrowdSimulation& crowd();

private:
    void assignWalkers();
    void assignPlanned(const SessionPlan& plan);
    void warnOfCrowding();
    void performDue();

    Steering m_steering; ///< none: nobody else says where people go
    std::unique_ptr<SessionParts> m_parts;
    std::unique_ptr<SessionRules> m_ruleHost;
};

} // namespace crowd::behavior
