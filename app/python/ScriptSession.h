// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/python/ScriptScene.h"
#include "behavior/session/RecordedSession.h"
#include "behavior/session/RunBeginning.h"
#include "behavior/surface/SurfacePlan.h"

namespace crowd::app {

/// A run of the simulation that a script steps by itself: the same as in the editor, without a
/// clock and without a window. Edits of the scene reach it at its next step. Starts as the scene is
/// when it is made. Knows nothing of Python. One thread at a time is let in: others wait, so call
/// it without Python's lock. Nothing in here asks the scene, which may want that lock.
class ScriptSession
{
public:
    /// Empty until it followed once. Recorded: its steps are kept. `beginning`: a moment of a take;
    /// nothing: as the scene has people.
    explicit ScriptSession(std::shared_ptr<ScriptScene> scene, bool isRecorded = false,
                           std::optional<behavior::RunBeginning> beginning = std::nullopt);
    ~ScriptSession();

    [[nodiscard]] const std::shared_ptr<ScriptScene>& scene() const { return m_scene; }
    /// Whether it knows the scene as of this revision, or a later one.
    [[nodiscard]] bool isUpToDate(std::uint64_t revision) const;
    /// Takes over what has been edited since the last time. An older one than is known is passed
    /// over. May be cancelled from another thread: then it is not up to date.
    void follow(const ScriptScene::Snapshot& now, const std::atomic<bool>& isCancelled);
    void step();
    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] double seconds() const; ///< that it has run, after those of its beginning
    [[nodiscard]] std::uint32_t stepsPerSecond() const { return m_stepsPerSecond; }
    /// Everybody as of the last step.
    [[nodiscard]] model::CrowdFramePtr frame() const;
    /// As of the step before; null: it is not recorded, or has made none.
    [[nodiscard]] model::CrowdFramePtr frameBefore() const;
    /// Whether each is still in the scene, by row of the frame.
    [[nodiscard]] std::vector<std::uint8_t> present() const;
    /// See Session::paths.
    [[nodiscard]] std::vector<model::PathId> paths() const;

    /// People take on a state in this session alone.
    model::StateRecall recall(const model::ChangeOver& change);
    /// Happens at the next step. The number is finite.
    void send(const std::string& event, float number, const std::vector<model::IndividualId>& ids);
    void sendTagged(const std::string& event, float number, std::uint8_t tag);
    [[nodiscard]] std::map<model::RuleId, std::uint64_t> fired() const;
    [[nodiscard]] std::vector<behavior::RuleFired> takeLog();
    /// What could not be followed or came to grief, in sentences.
    [[nodiscard]] std::vector<std::string> problems() const;

    /// Everybody as of the last step, to be kept in the scene.
    struct Pose
    {
        model::CrowdFramePtr shown;
        behavior::SessionPosePtr pose;
    };
    [[nodiscard]] Pose pose() const;
    /// Its steps, for readers on any thread; null: it does not record.
    [[nodiscard]] std::shared_ptr<behavior::MotionCache> motion();
    /// Where people are in the scene is where they are here.
    void adoptKept(const ScriptScene::Snapshot& kept);

private:
    void begin(const model::Scene& scene);
    void beginFrom(const behavior::RunBeginning& beginning);
    [[nodiscard]] behavior::Session& session() const { return m_run->session(); }

    std::shared_ptr<ScriptScene> m_scene;
    std::optional<behavior::RunBeginning> m_beginning; ///< until it has begun
    mutable std::mutex m_mutex;
    std::uint64_t m_revision = 0; ///< of the scene as it is known
    bool m_isComplete = false;    ///< following was not cancelled
    std::uint32_t m_stepsPerSecond = 30;
    behavior::SurfacePlan m_plan; ///< of the surface in use
    model::Message m_surfaceProblem;
    std::shared_ptr<behavior::MotionCache> m_motion;  ///< null: it does not record
    std::unique_ptr<behavior::RecordedSession> m_run; ///< null: nothing was followed yet
};

} // namespace crowd::app
