// SPDX-License-Identifier: MIT
#include "model/rules/MarkFlaws.h"

#include <algorithm>
#include <string>
#include <utility>

#include <QtCore/QString>

#include "model/base/ShownText.h"

namespace crowd::model {

namespace {

/// As the artist finds it in the timeline.
std::string shownTime(const Mark& mark)
{
    return QString::number(mark.seconds, 'f', 2).toStdString();
}

Message flawOfState(const Scene& scene, const Mark& mark, StateId state)
{
    const bool isThere = std::ranges::find(scene.states, state, &State::id) != scene.states.end();
    if (isThere) {
        return {};
    }
    return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline recalls a state that is not "
                                          "there. Choose another one for that mark."),
            shownTime(mark)};
}

Message flawOfCue(const Scene& scene, const Mark& mark)
{
    const auto cue = std::ranges::find(scene.cues, mark.cue, &Cue::id);
    if (cue == scene.cues.end()) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline calls a cue that is not "
                                              "there. Choose another one for that mark."),
                shownTime(mark)};
    }
    if (mark.people.empty() && cue->reach == CueReach::Selected) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline calls the cue “%2”, "
                                              "which speaks to the selected: the mark names "
                                              "nobody. Let the cue reach everybody, or a tag."),
                shownTime(mark), shortened(cue->name)};
    }
    return cue->state != 0 ? flawOfState(scene, mark, cue->state) : Message();
}

Message flawOfCamera(const Scene& scene, const Mark& mark)
{
    const bool isThere =
        mark.camera.empty() ||
        std::ranges::find(scene.cameras, mark.camera, &NamedCamera::name) != scene.cameras.end();
    if (!isThere) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline wants the camera “%2”, "
                                              "which is not there. Choose another one for that "
                                              "mark."),
                shownTime(mark), shortened(mark.camera)};
    }
    const auto path = std::ranges::find(scene.paths, mark.path, &Path::id);
    if (mark.move == CameraMove::Along && (path == scene.paths.end() || path->places.size() < 2)) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the camera is to travel along a path: "
                                              "choose one of at least two places for that mark."),
                shownTime(mark)};
    }
    if (mark.move == CameraMove::To && mark.camera.empty()) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the camera goes nowhere: choose a "
                                              "camera for that mark."),
                shownTime(mark)};
    }
    return {};
}

bool isAnybodyThere(const Scene& scene, const Mark& mark)
{
    return std::ranges::any_of(mark.people, [&people = scene.population](int id) {
        return people.rowOf(static_cast<IndividualId>(id)) < people.size();
    });
}

} // namespace

Message flawOf(const Scene& scene, const Mark& mark)
{
    if (mark.kind == MarkKind::Marker) {
        return {};
    }
    if (mark.kind == MarkKind::Camera) {
        return flawOfCamera(scene, mark);
    }
    if (!mark.people.empty() && !isAnybodyThere(scene, mark)) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline speaks to characters of "
                                              "whom none is there any more. Remove that mark."),
                shownTime(mark)};
    }
    if (mark.kind == MarkKind::Event && mark.event.empty()) {
        return {QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline sends an event without "
                                              "a name. Choose one for that mark."),
                shownTime(mark)};
    }
    if (mark.kind == MarkKind::State) {
        return flawOfState(scene, mark, mark.state);
    }
    return mark.kind == MarkKind::Cue ? flawOfCue(scene, mark) : Message();
}

std::map<MarkId, Message> flawsOfMarks(const Scene& scene)
{
    std::map<MarkId, Message> flaws;
    const Mark* camera = nullptr; // that came last
    const Timeline ordered = inOrder(scene.timeline);
    for (const Mark& mark : ordered) {
        if (Message flaw = flawOf(scene, mark); !flaw.empty()) {
            flaws.emplace(mark.id, std::move(flaw));
        }
        if (mark.kind != MarkKind::Camera) {
            continue;
        }
        if (camera != nullptr && camera->seconds == mark.seconds) {
            flaws.try_emplace(
                camera->id,
                Message{QT_TRANSLATE_NOOP("Messages", "At %1 seconds the timeline moves the camera "
                                                      "twice: only the later mark is seen. Move "
                                                      "one of them, or remove it."),
                        shownTime(mark)});
        }
        camera = &mark;
    }
    return flaws;
}

} // namespace crowd::model
