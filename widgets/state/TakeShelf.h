// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "model/document/SceneDocument.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Take.h"
#include "widgets/state/TakePlayback.h"
#include "widgets/tasks/BackgroundTask.h"

namespace crowd::widgets {

class SessionControl;

/// How two moments of the same people differ.
struct TakeDifference
{
    std::vector<std::size_t> rows;   ///< of those who are elsewhere
    std::vector<std::size_t> absent; ///< of those who are there in the other one only
    std::size_t extra = 0;           ///< there in the shown one only
    std::size_t people = 0;          ///< that were compared
    float mean = 0.0F;               ///< metres, of those who are elsewhere
    float most = 0.0F;               ///< metres
};

/// Of frames of the same scene.
[[nodiscard]] TakeDifference differenceOf(const model::CrowdFrame& shown,
                                          const model::CrowdFrame& other);

/// The takes of the scene: runs become new ones, in the background, and one of them can be seen
/// as ghosts beside what is shown. What is done to them is one undo step each. Main thread;
/// document and session outlive it.
class TakeShelf : public QObject
{
    Q_OBJECT

public:
    TakeShelf(model::SceneDocument& document, SessionControl& session, QObject* parent = nullptr);

    /// What has been played becomes a take of this name. False: nothing has been, or another one
    /// is being kept still.
    bool keep(const QString& name);
    /// Some people of the take that is shown do something else in a stretch of time, everybody else
    /// what he did: that becomes another take, which is shown. False: no take is shown, or another
    /// one is being kept still. `isDifferent`: dice fall otherwise than in the run.
    bool retake(std::vector<model::IndividualId> ids, double begin, double end, bool isDifferent);
    /// The share that is written; below 0: none is being kept.
    [[nodiscard]] float keptShare() const { return m_share; }
    /// Nobody waits any more for what is being kept.
    void cancel();

    /// Seen instead of a run; 0: none is.
    void show(model::TakeId id);
    void remove(model::TakeId id);
    void rename(model::TakeId id, const QString& name);

    /// Seen as ghosts; 0: none. Part of what is seen, not of the scene.
    void setGhost(model::TakeId id);
    [[nodiscard]] model::TakeId ghost() const { return m_ghost ? m_ghost->id() : 0; }
    /// Everybody as in that take; null: there is none.
    [[nodiscard]] model::CrowdFramePtr ghostFrame(double seconds) const;

Q_SIGNALS:
    /// How much of a take is kept.
    void keeping();
    void kept(const QString& name);
    /// Of so many people, who were brought home from so many metres at the end at most.
    void retaken(const QString& name, int people, double furthestMetres);
    /// A sentence on what went wrong.
    void failed(const QString& why);
    void ghostChanged();

private:
    [[nodiscard]] QString folder() const;
    bool add(model::Take take, const QString& text, bool isShown);
    void followScene(const model::SceneChange& change);
    void edit(const QString& text, const std::function<void(model::Takes& takes)>& change);

    model::SceneDocument& m_document;
    SessionControl& m_session;
    BackgroundTask m_task;
    QString m_name; ///< of the one that is being kept
    float m_share = -1.0F;
    std::unique_ptr<TakePlayback> m_ghost;
    mutable model::CrowdFramePtr m_ghostFrame;
    mutable std::uint64_t m_ghostRevision = 0;
};

/// "Take 3": a name that none has.
[[nodiscard]] QString freeTakeName(const model::Scene& scene);

} // namespace crowd::widgets
