// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/python/ScriptScene.h"
#include "behavior/session/Session.h"
#include "behavior/surface/SurfacePlan.h"

namespace crowd::app {

/// A run of the simulation that a script steps by itself: the same as in the editor, without a
/// clock and without a window. Edits of the scene reach it at its next step. Starts as the scene is
/// when it is made. Knows nothing of Python. One thread at a time is let in.
class ScriptSession
{
public:
    explicit ScriptSession(std::shared_ptr<ScriptScene> scene);
    ~ScriptSession();

    [[nodiscard]] const std::shared_ptr<ScriptScene>& scene() const { return m_scene; }
    /// Takes over what has been edited since the last time. Where the scene may be asked.
    void follow();
    void step();
    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] double seconds() const; ///< that it has run
    [[nodiscard]] std::uint32_t stepsPerSecond() const { return m_stepsPerSecond; }
    /// Everybody as of the last step.
    [[nodiscard]] model::CrowdFramePtr frame() const;

    /// Happens at the next step. The number is finite.
    void send(const std::string& event, float number, const std::vector<model::IndividualId>& ids);
    void sendTagged(const std::string& event, float number, std::uint8_t tag);
    [[nodiscard]] std::map<model::RuleId, std::uint64_t> fired() const;
    [[nodiscard]] std::vector<behavior::RuleFired> takeLog();
    /// What could not be followed or came to grief, in sentences.
    [[nodiscard]] std::vector<std::string> problems() const;

    /// Where everybody is now becomes where the scene has them: one undo step. How many people are
    /// another way than before.
    [[nodiscard]] model::Result<int> keepPose();

private:
    std::shared_ptr<ScriptScene> m_scene;
    mutable std::mutex m_mutex;
    std::uint64_t m_revision = 0; ///< of the scene as it is known
    std::uint32_t m_stepsPerSecond = 30;
    behavior::SurfacePlan m_plan; ///< of the surface in use
    std::string m_surfaceProblem;
    std::unique_ptr<behavior::Session> m_session;
};

} // namespace crowd::app
