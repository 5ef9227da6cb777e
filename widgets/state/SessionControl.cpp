// SPDX-License-Identifier: MIT
#include "widgets/state/SessionControl.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <QtCore/QMetaObject>

#include "behavior/session/PoseKeeping.h"
#include "behavior/session/RunBeginning.h"
#include "behavior/session/SessionPlayer.h"
#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/states/ChangeOver.h"
#include "model/states/StateKeeping.h"
#include "widgets/state/Invalidation.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/SceneSurface.h"
#include "widgets/state/TakePlayback.h"

namespace crowd::widgets {

namespace {

constexpr double kAheadSeconds = 0.1;  ///< at speed 1: edits and events are heard so much later
constexpr double kFurthestAhead = 4.0; ///< however long a picture takes
constexpr double kLongestSkip = 0.25;  ///< by which time may go on at an edit
constexpr double kNoEnd = 1e300;       ///< seconds

} // namespace

/// People who change over to what an edit has made of them: until the session's steps know of it,
/// they are shown as they were.
struct SessionControl::ChangingPeople
{
    model::ChangeOver change;
    model::Population before;
    std::uint64_t version = 0; ///< of the scene's people after it; 0: not yet
};

SessionControl::SessionControl(model::SceneDocument& document, Transport& transport,
                               QObject* parent)
    : QObject(parent), m_document(document), m_transport(transport), m_recorder(document, this),
      m_player(std::make_unique<behavior::SessionPlayer>([this] {
          QMetaObject::invokeMethod(
              this,
              [this] {
                  m_frame.reset(); // also where an edit made another of the same step
                  followProblems();
                  takeFirings();
                  m_recorder.add(m_player->takePerformed());
                  Q_EMIT stepped();
              },
              Qt::QueuedConnection);
      })),
      m_surface(std::make_unique<SceneSurface>(document))
{
    m_hand.setSingleShot(true);
    m_hand.setInterval(0);
    connect(&m_hand, &QTimer::timeout, this, &SessionControl::hand);
    followSurface();
    connect(&document, &model::SceneDocument::changed, this, &SessionControl::followScene);
    connect(&document, &model::SceneDocument::changingOver, this, &SessionControl::changeOver);
}

SessionControl::~SessionControl()
{
    m_player->stop();
}

void SessionControl::followSurface()
{
    connect(m_surface.get(), &SceneSurface::used, this, [this] {
        if (isRunning()) {
            m_player->setSurface(m_surface->current());
        }
    });
    connect(m_surface.get(), &SceneSurface::changed, this, &SessionControl::surfaceChanged);
    connect(m_surface.get(), &SceneSurface::found, this, [this] {
        if (std::exchange(m_isTakeWanted, false)) {
            beginInTake();
        }
    });
}

bool SessionControl::isRunning() const
{
    return m_player->isRunning();
}

void SessionControl::followScene(const model::SceneChange& change)
{
    visitChange(change, [this](const model::SceneReplaced&) {
        drop();
        m_liveSeconds = 0.0; // where time begins in it
        m_recorder.forget();
        m_firings.clear();
        m_take.reset();
    });
    if (isOneOf<model::TakesChanged, model::SceneReplaced>(change)) {
        followTakes();
    }
    if (m_take && isOneOf<model::TemplatesChanged>(change)) {
        showTake(model::shownTake(m_document.scene().takes)); // its edits by hand know them
    }
    m_isBehaviourStale = true;
    const bool isOfNoInterest =
        isOneOf<model::CamerasChanged, model::LightingChanged, model::LooksChanged,
                model::TakesChanged, model::SceneReplaced>(change);
    if (isRunning() && !isOfNoInterest && !m_isKeepingPose) {
        m_hand.start();
        invalidate(change);
    }
    if (isOneOf<model::PathsChanged>(change) && !isRunning()) {
        (void)m_surface->isReady(); // it will be wanted soon
    }
}

/// What comes after an edit in time; nothing before.
void SessionControl::invalidate(const model::SceneChange& change)
{
    if (isOneOf<model::TimelineChanged>(change)) {
        invalidateTimeline();
    } else if (changesMotion(change, m_document.scene())) {
        goToEdit();
    }
}

/// The session is a little ahead of what is shown: while nothing plays, nobody would see an edit.
void SessionControl::goToEdit()
{
    const double ahead = m_player->available() - m_transport.seconds();
    const bool isGoingOn = m_player->isBehind(); // to steps after those that are done
    const bool isSeen = m_transport.isPlaying() || (ahead <= 0.0 && !isGoingOn);
    const bool isFar = ahead > kLongestSkip || isGoingOn;
    if (m_transport.seconds() < m_liveSeconds || (!isSeen && isFar)) {
        m_liveSeconds = std::max(m_liveSeconds, m_player->available());
        goOnFromHere();
    } else if (!isSeen) {
        m_transport.setSeconds(m_player->available());
        m_liveSeconds = m_transport.seconds();
    }
}

/// Of a mark that is another one what happens from then on; the time that is shown stays.
void SessionControl::invalidateTimeline()
{
    const model::Timeline& now = m_document.scene().timeline;
    const model::Timeline before = std::exchange(m_timeline, now);
    const auto first = firstDifference(before, now, m_isFromScene ? 0.0 : m_startSeconds);
    const double shown = m_transport.seconds();
    if (!first || m_recorder.isKeeping() || *first > m_player->available()) {
        return; // it has happened already, or it is still to come
    }
    const double live = m_liveSeconds;
    if (m_isFromScene && *first <= m_startSeconds) {
        startAnew();
    } else if (m_player->takeBefore(*first)) {
        forgetPlayed();
        handPending(); // before it comes to the mark
    } else {
        return;
    }
    m_liveSeconds = std::max(shown, live); // as far as before it can be seen again
    m_player->request(m_liveSeconds);
}

/// What the scene has no behaviour for, a session is begun for: it lets people change over.
bool SessionControl::startForRecall()
{
    if (!isRunning() && !m_take && m_surface->isReady()) {
        m_isForRecall = !m_document.scene().hasBehaviour();
        start(beginningOfRun());
    }
    return isRunning();
}

void SessionControl::changeOver(const model::ChangeOver& change)
{
    const bool isSeen = m_transport.isPlaying() && !change.timing.isAtOnce();
    if (isRunning() || (isSeen && startForRecall())) {
        handPending();
        takeFromHere();
        m_changing =
            std::make_unique<ChangingPeople>(ChangingPeople{change, m_document.scene().population});
        m_changing->change.timing = isSeen ? change.timing : model::RecallTiming();
        m_hand.start(); // also where nobody changes: what comes later is no part of it
        goToEdit();     // rules may have changed whom the scene has like that already
    }
}

bool SessionControl::recall(const model::ChangeOver& change)
{
    const auto& states = m_document.scene().states;
    const auto state = std::ranges::find(states, change.state, &model::State::id);
    if (state == states.end() || change.ids.empty()) {
        return false;
    }
    model::Mark mark;
    mark.kind = model::MarkKind::State;
    mark.state = change.state;
    mark.setTiming(change.timing);
    if (change.ids != peopleOf(m_document.scene(), *state)) {
        mark.people.assign(change.ids.begin(), change.ids.end());
    }
    return perform(mark);
}

/// Whether it is worth a run of its own.
bool SessionControl::beginsRun(const model::Mark& mark) const
{
    const auto& cues = m_document.scene().cues;
    const auto cue = std::ranges::find(cues, mark.cue, &model::Cue::id);
    return mark.kind == model::MarkKind::State ||
           (mark.kind == model::MarkKind::Cue && cue != cues.end() && cue->state != 0);
}

bool SessionControl::perform(const model::Mark& mark)
{
    if (!isRunning() && !(beginsRun(mark) && startForRecall())) {
        return false;
    }
    handPending();
    takeFromHere();
    model::Mark part = mark;
    std::size_t first = 0;
    do { // a mark of the timeline names no more people than files hold
        const std::size_t end = std::min(mark.people.size(), first + model::kMostMarkPeople);
        part.people.assign(mark.people.begin() + static_cast<std::ptrdiff_t>(first),
                           mark.people.begin() + static_cast<std::ptrdiff_t>(end));
        part.id = m_recorder.nextId();
        m_player->perform(part);
        first = end;
    } while (first < mark.people.size());
    return true;
}

bool SessionControl::hasRecalled() const
{
    const auto pose = isRunning() ? poseAt(m_transport.seconds()) : nullptr;
    return pose && pose->recalled;
}

void SessionControl::hand()
{
    if (!isRunning()) {
        return;
    }
    (void)m_surface->isReady(); // the surface may be wanted from now on
    if (m_changing && m_changing->version == 0) {
        m_changing->version = m_document.scene().population.version();
        m_player->adopt(m_document.scene(), m_changing->change);
    } else {
        m_player->adopt(m_document.scene());
    }
    m_handed = std::make_shared<const model::Scene>(m_document.scene());
}

/// What was edited before something else happens.
void SessionControl::handPending()
{
    if (m_hand.isActive()) {
        m_hand.stop();
        hand();
    }
}

/// As they are still shown at a time; null: as the scene has them.
const model::Population* SessionControl::peopleBefore(double seconds) const
{
    if (!m_changing) {
        return nullptr;
    }
    const auto pose = poseAt(seconds);
    const std::uint64_t version = m_document.scene().population.version();
    const bool isOnItsWay = m_changing->version == 0 || (m_changing->version == version && pose &&
                                                         pose->sceneVersion != version);
    if (!isOnItsWay) {
        m_changing.reset();
    }
    const bool isSeen = m_changing && !m_changing->change.timing.isAtOnce();
    return isSeen ? &m_changing->before : nullptr;
}

/// Nobody changes over any more in a session that began for that alone.
void SessionControl::endRecall()
{
    const bool mayEnd = m_isForRecall && !m_hasBehaviour && !m_player->takenShare() &&
                        m_transport.seconds() >= m_liveSeconds;
    const auto pose = mayEnd ? poseAt(m_transport.seconds()) : nullptr;
    const bool isBehind =
        m_changing || (pose && pose->sceneVersion != m_document.scene().population.version());
    if (pose && pose->step > 0 && !isBehind && !pose->stateFades && !pose->recalled) {
        drop();
    }
}

bool SessionControl::isPosed() const
{
    return m_take || isRunning();
}

/// Null: as the scene has people.
behavior::SessionPosePtr SessionControl::poseAt(double seconds) const
{
    if (m_take) {
        return m_take->poseAt(seconds);
    }
    return isRunning() && seconds >= posedSince() ? m_player->poseAt(seconds) : nullptr;
}

std::shared_ptr<const behavior::WalkSurface> SessionControl::surface() const
{
    return m_surface->known();
}

double SessionControl::surfaceProgress() const
{
    return m_surface->progress();
}

QString SessionControl::surfaceProblem() const
{
    return m_surface->problem().empty() ? QString() : model::translated(m_surface->problem());
}

std::size_t SessionControl::surfacePolygons() const
{
    return m_surface->polygons();
}

/// What marks before the moment that is shown do has been done by then.
double SessionControl::beginningOfRun() const
{
    const double shown = m_transport.seconds();
    const bool isAsked =
        std::ranges::any_of(m_document.scene().timeline, [shown](const model::Mark& mark) {
            return model::isForPeople(mark.kind) && mark.seconds < shown;
        });
    return isAsked ? 0.0 : shown;
}

/// People begin as the scene has them.
void SessionControl::start(double seconds)
{
    noteStart(seconds);
    m_isFromScene = true;
    m_player->start(*m_handed, m_startSeconds, m_surface->current());
    if (m_startSeconds < m_transport.seconds()) {
        m_player->request(m_transport.seconds());
    }
    followProblems();
    Q_EMIT stateChanged();
}

/// In place of a run that is another one from its beginning, or began later than what is shown.
void SessionControl::startAnew()
{
    takeFirings();
    m_recorder.add(m_player->takePerformed());
    start(std::min(m_startSeconds, beginningOfRun()));
    Q_EMIT takenFrom(m_startSeconds);
}

/// They begin as they were at that moment.
void SessionControl::startFrom(behavior::RunBeginning beginning)
{
    m_transport.setSeconds(beginning.now->seconds);
    noteStart(beginning.now->seconds);
    m_isFromScene = false;
    m_player->start(*m_handed, std::move(beginning), m_surface->current());
    followProblems();
    Q_EMIT stateChanged();
}

void SessionControl::noteStart(double seconds)
{
    m_startSeconds = seconds;
    m_liveSeconds = m_transport.seconds();
    m_stepsPerSecond = m_document.scene().stepsPerSecond;
    m_firings.clear();
    m_timeline = m_document.scene().timeline;
    m_handed = std::make_shared<const model::Scene>(m_document.scene());
    m_changing.reset();
    m_frame.reset();
}

void SessionControl::drop()
{
    if (isRunning()) {
        takeFirings();
        m_recorder.add(m_player->takePerformed());
        m_player->stop();
        m_handed.reset();
        m_frame.reset();
        m_changing.reset();
        m_isForRecall = false;
        m_isFromScene = false;
        followProblems();
        Q_EMIT stateChanged();
    }
}

void SessionControl::advance(double realSeconds)
{
    if (m_isBehaviourStale) {
        m_isBehaviourStale = false;
        m_hasBehaviour = m_document.scene().hasBehaviour();
    }
    const bool begins = !isRunning() && !m_take && m_transport.isPlaying() && m_hasBehaviour;
    // Until what can be walked on is found time stands: the run has all of it from where it began.
    const bool waits = begins && !m_surface->isReady();
    if (begins && !waits) {
        start(beginningOfRun());
    }
    beginTakeAgain();
    advanceTransport(waits ? 0.0 : realSeconds);
    checkTake();
    if (!isRunning()) {
        m_liveSeconds = std::max(m_liveSeconds, m_transport.seconds());
        return;
    }
    m_liveSeconds = std::max(m_liveSeconds, m_transport.seconds());
    endRecall();
    if (m_transport.isPlaying()) {
        // What the next picture needs is there when it is drawn, if it takes as long as the last.
        const double speed = m_transport.state().speed;
        const double ahead =
            std::max(kAheadSeconds * std::max(1.0, speed), kAheadSeconds + realSeconds * speed);
        m_player->request(m_transport.seconds() + std::min(ahead, kFurthestAhead));
    }
}

/// Time, within what of the play range can be shown; a run that begins after it plays on.
void SessionControl::advanceTransport(double realSeconds)
{
    const model::PlayRange& range = m_document.scene().playRange;
    const bool isPlaying = m_transport.isPlaying();
    const double first = std::max(firstSeconds(), posedSince()); // what it does is played
    const bool isThere = range.isSet() && (!isPosed() || first < range.end);
    const bool isPartial = isPlaying && isThere && !m_document.isEditOpen();
    if (isPartial && m_transport.seconds() >= range.end && (range.isLoop || !m_wasPlaying)) {
        beginRange();
    }
    const bool isBefore = m_transport.seconds() < range.end;
    const double end = isPartial && isBefore ? range.end : kNoEnd;
    m_transport.advance(realSeconds, isPosed() ? std::min(availableSeconds(), end) : end);
    const bool isPast = isPartial && isBefore && m_transport.seconds() >= range.end;
    const bool isOver = m_take && m_transport.seconds() >= m_take->last();
    if ((isPast && !range.isLoop) || (isOver && isPlaying && !(isThere && range.isLoop))) {
        m_transport.setPlaying(false);
        if (isPast) {
            Q_EMIT rangeEnded();
        }
    } else if (isOver && isPlaying && isThere && range.isLoop) {
        beginRange(); // it ends within it
    }
    m_wasPlaying = m_transport.isPlaying();
}

/// The first of it that can be shown.
void SessionControl::beginRange()
{
    const double first = isPosed() ? std::max(firstSeconds(), posedSince()) : 0.0;
    m_transport.setSeconds(std::max(m_document.scene().playRange.begin, first));
}

void SessionControl::takeFirings()
{
    m_firings.add(m_player->takeLog(), m_startSeconds);
}

void SessionControl::stepOnce()
{
    m_transport.setPlaying(false);
    if (!isRunning() && !m_take && m_document.scene().hasBehaviour() && m_surface->isReady()) {
        start(beginningOfRun());
    }
    const double rate = stepRate();
    const double steps = std::floor((m_transport.seconds() - m_startSeconds) * rate + 1e-6) + 1.0;
    const double next = m_startSeconds + steps / rate;
    if (isRunning()) {
        m_player->request(next);
    }
    const double shown = isPosed() ? next : m_transport.seconds() + 1.0 / rate;
    m_transport.setSeconds(m_take ? std::min(shown, m_take->last()) : shown);
    m_liveSeconds = std::max(m_liveSeconds, m_transport.seconds());
}

void SessionControl::stepBack()
{
    m_transport.setPlaying(false);
    const double rate = stepRate();
    if (!isPosed()) {
        m_transport.setSeconds(std::max(0.0, m_transport.seconds() - 1.0 / rate));
        return;
    }
    const double steps = std::ceil((m_transport.seconds() - m_startSeconds) * rate - 1e-6) - 1.0;
    m_transport.setSeconds(std::max(firstSeconds(), m_startSeconds + steps / rate));
}

void SessionControl::catchUp()
{
    if (m_transport.seconds() < m_liveSeconds) {
        m_transport.setSeconds(m_liveSeconds);
    }
}

double SessionControl::firstSeconds() const
{
    if (m_take) {
        return m_take->first();
    }
    const double first = m_player->first();
    return first <= posedSince() ? 0.0 : first; // of long runs the beginning is not known any more
}

double SessionControl::posedSince() const
{
    return m_isFromScene ? m_startSeconds : 0.0;
}

double SessionControl::liveSeconds() const
{
    return m_liveSeconds;
}

/// Steps a second.
double SessionControl::stepRate() const
{
    return isRunning() ? m_stepsPerSecond : m_document.scene().stepsPerSecond;
}

void SessionControl::stop()
{
    drop();
    m_transport.setPlaying(false);
    m_transport.rewind();
    m_liveSeconds = 0.0;
    if (m_take) {
        m_transport.setSeconds(std::max(m_transport.seconds(), m_take->first()));
        m_liveSeconds = m_take->last();
    }
    Q_EMIT stateChanged();
}

void SessionControl::send(const model::EventSettings& event,
                          std::span<const model::IndividualId> ids)
{
    if (ids.empty()) {
        return; // a mark without people is for everybody
    }
    model::Mark mark;
    mark.kind = model::MarkKind::Event;
    mark.event = event.name;
    mark.payload = event.payload;
    mark.people.assign(ids.begin(), ids.end());
    (void)perform(mark);
}

void SessionControl::pose(model::CrowdFrame& frame) const
{
    if (m_take) {
        (void)m_take->pose(frame);
    } else if (isRunning() && frame.seconds >= posedSince()) {
        m_player->pose(frame);
    }
}

std::size_t SessionControl::goneCount() const
{
    const auto pose = poseAt(m_transport.seconds());
    return pose ? pose->gone : 0;
}

model::CrowdFramePtr SessionControl::frame(double seconds) const
{
    if (!isPosed()) {
        return m_document.frame(seconds);
    }
    const double available = availableSeconds();
    if (!m_frame || m_frame->seconds != seconds || m_frameAvailable != available ||
        m_frameRevision != m_document.revision()) {
        model::CrowdFrame frame = *m_document.frame(seconds);
        if (const model::Population* before = peopleBefore(seconds)) {
            frame.population = *before;
        }
        pose(frame);
        m_frame = std::make_shared<const model::CrowdFrame>(std::move(frame));
        m_frameAvailable = available;
        m_frameRevision = m_document.revision();
    }
    return m_frame;
}

std::shared_ptr<behavior::MotionCache> SessionControl::motion() const
{
    return m_take ? m_take->motion() : m_player->motion();
}

std::vector<model::IndividualId> SessionControl::lit() const
{
    const auto pose = poseAt(m_transport.seconds());
    return pose ? pose->lit : std::vector<model::IndividualId>();
}

void SessionControl::followProblems()
{
    std::vector<behavior::Problem> now;
    if (isRunning()) {
        now = m_player->report().problems;
    }
    if (now != m_problems) {
        m_problems = std::move(now);
        Q_EMIT problemsChanged();
    }
}

std::uint64_t SessionControl::firedCount(model::RuleId rule) const
{
    const auto report = m_player->report();
    const auto found = report.fired.find(rule);
    return found == report.fired.end() ? 0 : found->second;
}

void SessionControl::askTally()
{
    m_player->askTally();
}

behavior::SessionTally SessionControl::tally() const
{
    return m_player->tally();
}

double SessionControl::availableSeconds() const
{
    return m_take ? m_take->last() : m_player->available();
}

bool SessionControl::keepPose()
{
    if (!isPosed()) {
        return false;
    }
    const model::CrowdFramePtr shown = frame(m_transport.seconds());
    const behavior::SessionPosePtr pose = poseAt(m_transport.seconds());
    if (!m_document.isEditOpen()) {
        takeFromHere(); // it goes on from there
    }
    m_isKeepingPose = true;
    int people = 0;
    const auto outcome = m_document.edit([&](model::SceneEdit& edit) {
        people = behavior::keepPose(edit, shown->population, pose.get());
        return tr("Keep the pose of %n character(s)", nullptr, people);
    });
    m_isKeepingPose = false;
    if (outcome == model::EditOutcome::Refused) {
        return false;
    }
    if (isRunning()) {
        m_handed = std::make_shared<const model::Scene>(m_document.scene());
        m_player->adopt(*m_handed, true);
    }
    Q_EMIT posesKept(people);
    return outcome == model::EditOutcome::Committed;
}

model::Scene SessionControl::shownScene() const
{
    if (!isPosed()) {
        return m_document.scene();
    }
    model::SceneDocument scratch;
    scratch.replaceScene(m_document.scene(), {});
    const model::CrowdFramePtr shown = frame(m_transport.seconds());
    const behavior::SessionPosePtr pose = poseAt(m_transport.seconds());
    scratch.edit(QString(), [&](model::SceneEdit& edit) {
        (void)behavior::keepPose(edit, shown->population, pose.get());
        behavior::keepClips(edit, shown->population);
    });
    return scratch.scene();
}

} // namespace crowd::widgets
