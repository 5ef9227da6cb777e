// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "behavior/session/RecordedSession.h"

namespace crowd::behavior {

class EditedTake;

/// What can be walked on in a scene; null: open ground, or `problem` says why it could not be
/// found. Takes seconds for large stages; may be cancelled from another thread.
[[nodiscard]] std::shared_ptr<const WalkSurface>
surfaceOf(const model::Scene& scene, model::Message& problem,
          const std::atomic<bool>* isCancelled = nullptr);

/// Times of a scene are asked for up to here, and down to its negative: a week.
inline constexpr double kMostSceneSeconds = 604'800.0;

/// What a scene looks like at a time, without a window: as in the take that it shows, simulated
/// from 0 where it has behaviour, else the clips' clock alone. What has been simulated is kept as
/// in the editor, and the same bit for bit when it is asked for again; where that is no longer
/// known it begins anew. One thread.
class SceneMotion
{
public:
    /// The scene's stages are loaded; it outlives this. What is cancelled, from another thread, is
    /// of no use.
    explicit SceneMotion(const model::Scene& scene, const std::atomic<bool>* isCancelled = nullptr);
    ~SceneMotion();

    /// Null: cancelled from another thread, and may be asked again. `notify` is called after each
    /// step with the time that is simulated, seconds.
    using Progress = std::function<void(double seconds)>;
    [[nodiscard]] model::CrowdFramePtr
    at(double seconds, const std::atomic<bool>* isCancelled = nullptr, const Progress& notify = {});
    /// Sentences about what could not be followed, in English.
    [[nodiscard]] std::vector<std::string> problems() const;

private:
    void begin();
    [[nodiscard]] bool openShownTake();
    [[nodiscard]] std::pair<SessionPosePtr, SessionPosePtr>
    around(double seconds, const std::atomic<bool>* isCancelled, const Progress& notify);

    const model::Scene& m_scene;
    std::shared_ptr<const std::vector<model::TemplateEntry>> m_templates;
    std::shared_ptr<const WalkSurface> m_surface;
    model::Message m_surfaceProblem;
    model::Message m_takeProblem;
    std::unique_ptr<EditedTake> m_take; ///< null: none is shown
    std::unique_ptr<RecordedSession> m_run;
};

} // namespace crowd::behavior
