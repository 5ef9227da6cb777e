// SPDX-License-Identifier: MIT
// Takes, and going on from a moment that has been played: see SessionControl.h.
#include <algorithm>
#include <memory>
#include <utility>

#include "behavior/session/SessionPlayer.h"
#include "behavior/takes/TakeBeginning.h"
#include "behavior/takes/TakeFile.h"
#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "widgets/state/SceneSurface.h"
#include "widgets/state/SessionControl.h"
#include "widgets/state/TakePlayback.h"

namespace crowd::widgets {

bool SessionControl::canTakeFromHere() const
{
    return m_take || (isRunning() && m_transport.seconds() < m_liveSeconds);
}

void SessionControl::takeFromHere()
{
    if (m_take) {
        m_isTakeWanted = !m_surface->isReady();
        if (!m_isTakeWanted) {
            beginInTake();
        }
    } else if (canTakeFromHere()) {
        goOnFromHere();
    }
}

/// A run instead of the take that is shown.
void SessionControl::beginInTake()
{
    const model::Scene& scene = m_document.scene();
    const model::Take* shown = model::findTake(scene.takes, take());
    auto beginning = behavior::beginningIn(*shown, scene, m_transport.seconds());
    if (!beginning) {
        m_takeProblem = beginning.error().said;
        Q_EMIT stateChanged();
        return;
    }
    const QString name = QString::fromStdString(shown->name);
    const bool wasPlaying = m_transport.isPlaying();
    const auto outcome =
        m_document.edit(tr("Take it from take \"%1\"").arg(name), [](model::SceneEdit& edit) {
            model::Takes takes = edit.scene().takes;
            for (model::Take& each : takes) {
                each.isShown = false;
            }
            edit.set<model::members::Takes>(std::move(takes));
        });
    if (outcome != model::EditOutcome::Committed) {
        return; // somebody else is editing
    }
    startFrom(std::move(beginning).value());
    m_transport.setPlaying(wasPlaying);
    Q_EMIT takenOutOf(name, m_startSeconds);
}

/// The run began out of a take, and goes on from a moment before that.
void SessionControl::beginInEarlier()
{
    auto beginning = behavior::beginningIn(m_player->motion(), m_transport.seconds());
    if (!beginning) {
        catchUp();
        Q_EMIT takeRefused();
        return;
    }
    takeFirings();
    m_recorder.add(m_player->takePerformed());
    startFrom(std::move(*beginning));
    Q_EMIT takenFrom(m_startSeconds);
}

/// From the time that is shown, also from the latest.
void SessionControl::goOnFromHere()
{
    const double shown = m_transport.seconds();
    if (shown < posedSince()) {
        startAnew();
        return;
    }
    if (shown < m_startSeconds && m_player->first() < m_startSeconds) {
        beginInEarlier();
        return;
    }
    if (!m_player->takeFrom(m_transport.seconds())) {
        catchUp();
        Q_EMIT takeRefused();
        return;
    }
    if (!m_transport.isPlaying()) { // at a step: what is done at it is seen at it
        m_transport.setSeconds(m_player->available());
    }
    m_liveSeconds = m_transport.seconds();
    forgetPlayed();
    m_player->request(m_liveSeconds);
}

/// After the step from which the run goes on.
void SessionControl::forgetPlayed()
{
    const double from = m_player->available();
    m_firings.forgetAfter(from);
    m_frame.reset();
    // What was edited later counts, too, but nobody is put anywhere by it.
    m_player->adopt(*m_handed, true);
    Q_EMIT takenFrom(from);
}

double SessionControl::takenShare() const
{
    return m_player->takenShare().value_or(-1.0);
}

model::TakeId SessionControl::take() const
{
    return m_take ? m_take->id() : 0;
}

QString SessionControl::takeProblem() const
{
    return m_takeProblem.empty() ? QString() : model::translated(m_takeProblem);
}

/// Which take the scene shows now, if any.
void SessionControl::followTakes()
{
    const model::Take* shown = model::shownTake(m_document.scene().takes);
    if (shown == nullptr || !m_take || !m_take->shows(*shown)) {
        showTake(shown);
    }
}

/// Null: none, so that what can be played begins where the take did.
void SessionControl::showTake(const model::Take* take)
{
    m_isTakeWanted = false;
    const bool wasShown = m_take != nullptr;
    const double began = wasShown ? m_take->first() : 0.0;
    m_take.reset();
    m_takeProblem = {};
    if (take != nullptr) {
        auto opened = TakePlayback::open(*take, m_document.scene());
        if (opened) {
            drop();
            m_take = std::move(opened).value();
            m_startSeconds = m_take->first();
            m_stepsPerSecond = m_document.scene().stepsPerSecond;
            const double seconds = m_transport.seconds();
            const bool isWithin = seconds >= m_take->first() && seconds < m_take->last();
            // From its beginning it can be played; out of another one the moment stays.
            m_transport.setSeconds(isWithin   ? seconds
                                   : wasShown ? std::clamp(seconds, m_take->first(), m_take->last())
                                              : m_take->first());
            m_liveSeconds = m_take->last();
        } else {
            m_takeProblem = opened.error().said;
        }
    }
    if (wasShown && !m_take) {
        m_transport.setPlaying(false);
        m_transport.setSeconds(began);
        m_liveSeconds = began;
    }
    m_frame.reset();
    Q_EMIT stateChanged();
}

/// What cannot be read any more is said once.
void SessionControl::checkTake()
{
    if (m_take && m_takeProblem.empty() && !m_take->poseAt(m_transport.seconds())) {
        m_takeProblem = behavior::damagedTake();
        m_frame.reset();
        Q_EMIT stateChanged();
    }
}

/// At its end play begins it, or the range within it, again.
void SessionControl::beginTakeAgain()
{
    const bool begins = m_transport.isPlaying() && !m_wasPlaying;
    if (m_take && begins && m_transport.seconds() >= m_take->last()) {
        const model::PlayRange& range = m_document.scene().playRange;
        const bool isWithin = range.isSet() && range.begin < m_take->last();
        m_transport.setSeconds(isWithin ? std::max(range.begin, m_take->first()) : m_take->first());
    }
}

} // namespace crowd::widgets
