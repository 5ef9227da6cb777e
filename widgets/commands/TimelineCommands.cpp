// SPDX-License-Identifier: MIT
#include "widgets/commands/TimelineCommands.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QtCore/QCoreApplication>

#include "model/document/SceneEdit.h"
#include "model/rules/RuleSets.h"
#include "widgets/commands/StateCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/state/Cues.h"
#include "widgets/state/Scrub.h"

namespace crowd::widgets {

using model::Mark;
using model::MarkId;
using model::MarkKind;
using model::Timeline;

namespace {

constexpr double kSameMoment = 1e-3; ///< seconds
constexpr double kUsualRange = 10.0; ///< seconds

struct MarkText
{
    Q_DECLARE_TR_FUNCTIONS(TimelineCommands)
};

/// What the camera does, so that it does something at once: it looks from then on as the view does
/// now. A view that is no camera of the scene yet becomes one.
std::vector<model::NamedCamera> camerasWithView(const EditorState& state, Mark& mark)
{
    std::vector<model::NamedCamera> cameras = state.scene().cameras;
    const ViewCamera& view = state.viewCamera();
    const QString name = view.name.isEmpty() ? freeCameraName(state, {}) : view.name;
    mark.camera = name.toStdString();
    if (std::ranges::find(cameras, mark.camera, &model::NamedCamera::name) == cameras.end()) {
        cameras.push_back({mark.camera, view.camera});
    }
    return cameras;
}

bool putTimeline(EditorState& state, const QString& undoText, Timeline timeline)
{
    const auto outcome = state.document().edit(undoText, [&timeline](model::SceneEdit& edit) {
        edit.set<model::members::Timeline>(std::move(timeline));
    });
    return outcome != model::EditOutcome::Refused;
}

QString nameOfState(const model::Scene& scene, model::StateId id)
{
    const auto found = std::ranges::find(scene.states, id, &model::State::id);
    return found == scene.states.end() ? MarkText::tr("missing state")
                                       : QString::fromStdString(found->name);
}

QString nameOfCue(const model::Scene& scene, model::CueId id)
{
    const auto found = std::ranges::find(scene.cues, id, &model::Cue::id);
    return found == scene.cues.end() ? MarkText::tr("missing cue") : cueTitle(scene, *found);
}

/// What a new mark does, so that it does something at once.
void beginWith(Mark& mark, const EditorState& state)
{
    const model::Scene& scene = state.scene();
    if (mark.kind == MarkKind::Cue && !scene.cues.empty()) {
        mark.cue = scene.cues.front().id;
    } else if (mark.kind == MarkKind::State && !scene.states.empty()) {
        const auto chosen = std::ranges::find(scene.states, state.chosenState(), &model::State::id);
        mark.state = chosen != scene.states.end() ? chosen->id : scene.states.front().id;
        mark.setTiming(timingNow(state));
    } else if (mark.kind == MarkKind::Event) {
        const auto events = model::eventsOf(scene);
        mark.event = events.empty() ? std::string() : events.front();
    }
}

/// Seconds: what has been played, and what is to happen.
double lastOfInterest(EditorState& state)
{
    double last = Scrub(state).last();
    for (const Mark& mark : state.scene().timeline) {
        last = std::max(last, mark.seconds + mark.length());
    }
    return last;
}

QString nameOfMove(const model::Scene& scene, const Mark& mark)
{
    QString camera = QString::fromStdString(mark.camera);
    if (mark.move == model::CameraMove::Around) {
        return camera.isEmpty() ? MarkText::tr("Around")
                                : MarkText::tr("Around, from %1").arg(camera);
    }
    const auto path = std::ranges::find(scene.paths, mark.path, &model::Path::id);
    if (mark.move == model::CameraMove::Along) {
        return path != scene.paths.end()
                   ? MarkText::tr("Along %1").arg(QString::fromStdString(path->name))
                   : MarkText::tr("missing path");
    }
    return camera;
}

QString missing(const Mark& mark)
{
    if (mark.kind == MarkKind::Cue && mark.cue == 0) {
        return MarkText::tr("The scene has no cues yet: the panel Rules makes them.");
    }
    if (mark.kind == MarkKind::State && mark.state == 0) {
        return MarkText::tr("The scene has no states yet: the panel States keeps them.");
    }
    return {};
}

} // namespace

QString markTitle(const model::Scene& scene, const Mark& mark)
{
    if (!mark.name.empty()) {
        return QString::fromStdString(mark.name);
    }
    switch (mark.kind) {
    case MarkKind::Cue:
        return nameOfCue(scene, mark.cue);
    case MarkKind::State:
        return nameOfState(scene, mark.state);
    case MarkKind::Event:
        return QString::fromStdString(mark.event);
    case MarkKind::Camera:
        return nameOfMove(scene, mark);
    case MarkKind::Marker:
        break;
    }
    return {};
}

MarkId addMark(EditorState& state, MarkKind kind, double seconds)
{
    Timeline timeline = state.scene().timeline;
    Mark mark;
    mark.id = model::freeMarkId(timeline);
    mark.kind = kind;
    mark.seconds = std::clamp(seconds, 0.0, model::kLatestMark);
    beginWith(mark, state);
    if (mark.id == 0) {
        state.showStatus(MarkText::tr("A timeline has at most %1 marks: remove some first.")
                             .arg(model::kMostMarks));
        return 0;
    }
    if (const QString why = missing(mark); !why.isEmpty()) {
        state.showStatus(why);
        return 0;
    }
    const MarkId id = mark.id;
    std::vector<model::NamedCamera> cameras;
    if (kind == MarkKind::Camera) {
        cameras = camerasWithView(state, mark);
    }
    const QString camera = QString::fromStdString(mark.camera);
    timeline.push_back(std::move(mark));
    const auto outcome =
        state.document().edit(MarkText::tr("Add a mark"), [&](model::SceneEdit& edit) {
            if (cameras.size() > state.scene().cameras.size()) {
                edit.setCameras(std::move(cameras));
            }
            edit.set<model::members::Timeline>(std::move(timeline));
        });
    if (outcome == model::EditOutcome::Refused) {
        return 0;
    }
    if (kind == MarkKind::Camera) {
        state.setCamera(state.camera(), camera);
    }
    return id;
}

void addCameraNow(EditorState& state)
{
    const double now = state.transport().seconds();
    const MarkId id = addMark(state, MarkKind::Camera, now);
    if (const Mark* mark = model::findMark(state.scene().timeline, id)) {
        state.showStatus(MarkText::tr("From %1 s on the camera looks as now: “%2”")
                             .arg(now, 0, 'f', 2)
                             .arg(QString::fromStdString(mark->camera)));
    }
}

void addMarkerNow(EditorState& state)
{
    const double now = state.transport().seconds();
    if (addMark(state, MarkKind::Marker, now) != 0) {
        state.showStatus(MarkText::tr("Marked at %1 s").arg(now, 0, 'f', 2));
    }
}

void removeMarks(EditorState& state, const MarkIds& marks)
{
    Timeline timeline = state.scene().timeline;
    std::erase_if(timeline, [&marks](const Mark& mark) { return marks.contains(mark.id); });
    if (timeline.size() != state.scene().timeline.size()) {
        (void)putTimeline(state, MarkText::tr("Remove marks"), std::move(timeline));
    }
}

void shiftMarks(EditorState& state, const MarkIds& marks, double seconds)
{
    Timeline timeline = state.scene().timeline;
    for (Mark& mark : timeline) {
        if (marks.contains(mark.id)) {
            mark.seconds = std::clamp(mark.seconds + seconds, 0.0, model::kLatestMark);
        }
    }
    (void)putTimeline(state, MarkText::tr("Move marks"), std::move(timeline));
}

MarkIds copyMarks(EditorState& state, const MarkIds& marks, double seconds)
{
    Timeline timeline = state.scene().timeline;
    MarkIds copies;
    for (const MarkId id : marks) {
        const Mark* mark = model::findMark(state.scene().timeline, id);
        const MarkId next = model::freeMarkId(timeline);
        if (mark != nullptr && next != 0) {
            Mark copy = *mark;
            copy.id = next;
            copy.seconds = std::clamp(copy.seconds + seconds, 0.0, model::kLatestMark);
            copies.insert(next);
            timeline.push_back(std::move(copy));
        }
    }
    return putTimeline(state, MarkText::tr("Copy marks"), std::move(timeline)) ? copies : MarkIds();
}

Timeline withMark(const Timeline& timeline, MarkId id, const std::function<void(Mark&)>& apply)
{
    Timeline changed = timeline;
    for (Mark& mark : changed) {
        if (mark.id == id) {
            apply(mark);
        }
    }
    return changed;
}

void setPlayRange(EditorState& state, model::PlayRange range)
{
    const model::PlayRange& before = state.scene().playRange;
    range.unknownMembers = before.unknownMembers;
    range.begin = std::clamp(range.begin, 0.0, model::kLatestMark);
    range.end = std::clamp(range.end, 0.0, model::kLatestMark);
    if (!range.isSet()) {
        range.begin = range.end = 0.0;
        range.isLoop = false;
    }
    if (range != before) {
        (void)state.document().edit(MarkText::tr("Change the play range"),
                                    [&range](model::SceneEdit& edit) {
                                        edit.set<model::members::Range>(std::move(range));
                                    });
    }
}

void beginPlayRange(EditorState& state, double seconds)
{
    model::PlayRange range = state.scene().playRange;
    const double length = range.isSet() ? range.end - range.begin : kUsualRange;
    range.begin = std::max(0.0, seconds);
    range.end = range.isSet() ? range.end : lastOfInterest(state);
    if (range.end <= range.begin) {
        range.end = range.begin + length;
    }
    setPlayRange(state, range);
}

void endPlayRange(EditorState& state, double seconds)
{
    model::PlayRange range = state.scene().playRange;
    const double length = range.isSet() ? range.end - range.begin : kUsualRange;
    range.end = seconds;
    if (range.end <= range.begin) {
        range.begin = std::max(0.0, range.end - length);
    }
    setPlayRange(state, range);
}

void setPlayLoop(EditorState& state, bool isLoop)
{
    model::PlayRange range = state.scene().playRange;
    range.isLoop = isLoop;
    if (isLoop && !range.isSet()) {
        range.begin = 0.0;
        range.end = std::max(lastOfInterest(state), kUsualRange);
    }
    setPlayRange(state, range);
}

void showRangeEdge(EditorState& state, bool isEnd)
{
    const Scrub scrub(state);
    const model::PlayRange& range = state.scene().playRange;
    if (isEnd) {
        showMoment(state, range.isSet() ? range.end : scrub.last());
    } else {
        showMoment(state, range.isSet() ? range.begin : scrub.first());
    }
}

void showNextMark(EditorState& state, bool isForward)
{
    const double now = state.transport().seconds();
    const Timeline ordered = model::inOrder(state.scene().timeline);
    const auto isPast = [&](const Mark& mark) {
        return mark.seconds < now + (isForward ? kSameMoment : -kSameMoment);
    };
    const auto next = std::ranges::partition_point(ordered, isPast);
    const bool isNone = isForward ? next == ordered.end() : next == ordered.begin();
    if (isNone) {
        state.showStatus(isForward ? MarkText::tr("There is no mark after this moment.")
                                   : MarkText::tr("There is no mark before this moment."));
        return;
    }
    showMoment(state, (isForward ? next : std::prev(next))->seconds);
}

void showMoment(EditorState& state, double seconds)
{
    Scrub scrub(state);
    const double last = scrub.last();
    scrub.show(seconds);
    if (seconds > state.transport().seconds() + kSameMoment) {
        state.showStatus(MarkText::tr("It has been played up to %1 s: play on to see more.")
                             .arg(last, 0, 'f', 2));
    }
}

} // namespace crowd::widgets
