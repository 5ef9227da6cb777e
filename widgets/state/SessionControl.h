// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>

#include "behavior/base/Problem.h"
#include "behavior/session/SessionTally.h"
#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"
#include "model/document/SceneDocument.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Take.h"
#include "model/scene/Timeline.h"
#include "widgets/state/FiringHistory.h"
#include "widgets/state/MarkRecorder.h"
#include "widgets/state/Transport.h"

namespace crowd::behavior {
class MotionCache;
struct RunBeginning;
class SessionPlayer;
class WalkSurface;
struct SessionPose;
} // namespace crowd::behavior

namespace crowd::model {
struct ChangeOver;
} // namespace crowd::model

namespace crowd::widgets {

class SceneSurface;
class TakePlayback;

/// Play, as the artist knows it: while the scene has behaviour, playing runs a session that starts
/// from the scene and never writes to it; without, only the clips' clock. Edits reach a running
/// session at the time that is shown: what it does later is then computed anew, what it did before
/// stays. What can be walked on is found in the background first. Where the scene shows a kept take
/// there is no run: people move as they did in it. Main thread; document and transport outlive
/// it.
class SessionControl : public QObject
{
    Q_OBJECT

public:
    SessionControl(model::SceneDocument& document, Transport& transport, QObject* parent = nullptr);
    ~SessionControl() override;

    [[nodiscard]] bool isRunning() const;
    /// A kept take is shown; 0: none.
    [[nodiscard]] model::TakeId take() const;
    /// Why the take that the scene shows is not; empty: it is, or there is none.
    [[nodiscard]] QString takeProblem() const;
    /// People are where time has brought them, by a run or in a take.
    [[nodiscard]] bool isPosed() const;
    /// Real time that has passed since the last frame. At the end of the scene's play range it
    /// begins that again, or pauses; not while a stroke is under way.
    void advance(double realSeconds);
    /// One step, then pause.
    void stepOnce();
    /// As it was a step before, then pause. Nothing where that is not known any more.
    void stepBack();
    /// To the latest time that was shown, from an earlier one.
    void catchUp();
    /// The run goes on from the time that is shown, and what has been played after it is
    /// forgotten: edits and what is sent to people do that by themselves. Out of a take that is
    /// shown a run begins in its place, as soon as what can be walked on is known; it goes on with
    /// people as they are in the take, which stays as it is. Nothing at the latest time of a run.
    void takeFromHere();
    [[nodiscard]] bool canTakeFromHere() const;
    /// The share that is computed of what comes before that time; below 0: it is there.
    [[nodiscard]] double takenShare() const;
    /// The earliest time that can be shown again.
    [[nodiscard]] double firstSeconds() const;
    /// Before this time people are as the scene has them, also while a run is shown.
    [[nodiscard]] double posedSince() const;
    /// The latest that has been shown since the run was taken from an earlier time, if it was.
    [[nodiscard]] double liveSeconds() const;
    /// Back to the scene, at the start of time, paused.
    void stop();
    /// Where everybody is now becomes where the scene has them: one undo step.
    bool keepPose();
    /// The scene as keepPose() would make it, with people in the clips that they are seen in;
    /// without a session as it is.
    [[nodiscard]] model::Scene shownScene() const;
    /// What happens at a mark happens in the run now, whenever the mark is. For a state, or a cue
    /// that recalls one, a run begins where there is none. False: there is none, or it cannot begin
    /// yet, and nothing happens.
    bool perform(const model::Mark& mark);
    /// People take on a state of the scene in the run alone; see perform().
    bool recall(const model::ChangeOver& change);
    /// While it is on, what is performed becomes a mark of the timeline.
    [[nodiscard]] MarkRecorder& recorder() { return m_recorder; }
    /// Whether people differ from the scene since a state was recalled in the run alone.
    [[nodiscard]] bool hasRecalled() const;
    /// To a running session only.
    void send(const model::EventSettings& event, std::span<const model::IndividualId> ids);

    /// What is shown at a time of the transport.
    [[nodiscard]] model::CrowdFramePtr frame(double seconds) const;
    void pose(model::CrowdFrame& frame) const;
    /// All that has been played, or the take that is shown, for readers on any thread; null:
    /// neither.
    [[nodiscard]] std::shared_ptr<behavior::MotionCache> motion() const;
    /// For whom a rule has just fired; ascending.
    [[nodiscard]] std::vector<model::IndividualId> lit() const;
    /// What the session has to say to the artist, as of its last step.
    [[nodiscard]] const std::vector<behavior::Problem>& problems() const { return m_problems; }
    [[nodiscard]] std::uint64_t firedCount(model::RuleId rule) const;
    /// Of the run, or of the one before where nothing runs.
    [[nodiscard]] const FiringHistory& firings() const { return m_firings; }
    /// People are counted once more; stepped() comes when that is done.
    void askTally();
    /// How many people of the running session are where, as last counted.
    [[nodiscard]] behavior::SessionTally tally() const;
    /// People of the scene who have left it in the running session, at the time that is shown.
    [[nodiscard]] std::size_t goneCount() const;
    /// Time of the last step that is done, of the transport.
    [[nodiscard]] double availableSeconds() const;

    /// What can be walked on, as far as it is known and of the stages of now; null: open ground, or
    /// it has not been found yet.
    [[nodiscard]] std::shared_ptr<const behavior::WalkSurface> surface() const;
    /// Share of the walkable surface that is built; below 0: nothing is being built.
    [[nodiscard]] double surfaceProgress() const;
    /// Polygons of the surface in use; 0: open ground.
    [[nodiscard]] std::size_t surfacePolygons() const;
    /// Empty: none.
    [[nodiscard]] QString surfaceProblem() const;

Q_SIGNALS:
    /// Runs, or does not any more.
    void stateChanged();
    /// A step is done.
    void stepped();
    /// The surface is being built, or is done.
    void surfaceChanged();
    void posesKept(int people);
    /// The session has something else to say than before.
    void problemsChanged();
    /// What was played after this time, seconds, is forgotten.
    void takenFrom(double seconds);
    /// It was paused at the end of the play range.
    void rangeEnded();
    /// Too much was edited since the run began: it goes on at the latest time.
    void takeRefused();
    /// A run has begun out of a take, at this time.
    void takenOutOf(const QString& take, double seconds);

private:
    struct ChangingPeople;

    void followScene(const model::SceneChange& change);
    void invalidate(const model::SceneChange& change);
    void invalidateTimeline();
    void goToEdit();
    void goOnFromHere();
    void beginInTake();
    void beginInEarlier();
    void forgetPlayed();
    void changeOver(const model::ChangeOver& change);
    void hand();
    void handPending();
    [[nodiscard]] bool startForRecall();
    void endRecall();
    void followTakes();
    void showTake(const model::Take* take);
    void beginTakeAgain();
    void checkTake();
    [[nodiscard]] std::shared_ptr<const behavior::SessionPose> poseAt(double seconds) const;
    void takeFirings();
    void advanceTransport(double realSeconds);
    void beginRange();
    [[nodiscard]] const model::Population* peopleBefore(double seconds) const;
    void start(double seconds);
    void startAnew();
    [[nodiscard]] double beginningOfRun() const;
    void startFrom(behavior::RunBeginning beginning);
    void noteStart(double seconds);
    void drop();
    void followSurface();
    [[nodiscard]] double stepRate() const;
    void followProblems();
    [[nodiscard]] bool beginsRun(const model::Mark& mark) const;

    model::SceneDocument& m_document;
    Transport& m_transport;
    MarkRecorder m_recorder;
    std::unique_ptr<behavior::SessionPlayer> m_player;
    std::unique_ptr<TakePlayback> m_take; ///< null: none is shown
    model::Message m_takeProblem;
    std::unique_ptr<SceneSurface> m_surface;
    std::vector<behavior::Problem> m_problems;
    QTimer m_hand;                       ///< the edits of one stroke's moment go together
    double m_startSeconds = 0.0;         ///< of the transport, when the session began
    double m_liveSeconds = 0.0;          ///< the latest that has been shown
    std::uint32_t m_stepsPerSecond = 30; ///< of the session
    /// An edit that is on its way to the session; null: none.
    mutable std::unique_ptr<ChangingPeople> m_changing;
    FiringHistory m_firings;
    model::Timeline m_timeline;                   ///< as the session knows it
    std::shared_ptr<const model::Scene> m_handed; ///< the scene as it was handed last; null: no run
    bool m_wasPlaying = false;                    ///< as of the last frame
    bool m_isForRecall = false; ///< the scene has no behaviour: the session began for a recall
    bool m_isFromScene = false; ///< people began as the scene has them, not out of another run
    bool m_isKeepingPose = false;
    bool m_isTakeWanted = false; ///< as soon as the surface is there: see takeFromHere()
    bool m_hasBehaviour = false;
    bool m_isBehaviourStale = true;
    // The frame made last, for the next who asks.
    mutable model::CrowdFramePtr m_frame;
    mutable double m_frameAvailable = -1.0;
    mutable std::uint64_t m_frameRevision = 0;
};

} // namespace crowd::widgets
