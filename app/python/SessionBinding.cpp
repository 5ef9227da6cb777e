// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/ColumnRules.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "app/python/ScriptPeople.h"
#include "app/python/ScriptSession.h"
#include "app/python/ScriptStates.h"
#include "app/python/ScriptTakes.h"

namespace crowd::app {

using namespace model;

namespace {

/// An edit of the scene has reached it when it is used.
ScriptSession& upToDate(ScriptSession& session)
{
    const std::uint64_t revision = session.scene()->revision();
    if (outsidePython([&] { return session.isUpToDate(revision); })) {
        return session;
    }
    const ScriptScene::Snapshot now = session.scene()->snapshot();
    std::atomic<bool> isCancelled{false};
    mindingSignals(isCancelled, [&] { session.follow(now, isCancelled); });
    return session;
}

std::shared_ptr<ScriptSession> makeSession(const ScenePtr& scene, bool isRecorded,
                                           const std::optional<std::string>& take, double time)
{
    if (!std::isfinite(time)) {
        throw ScriptError("time must be a number of seconds.");
    }
    std::optional<behavior::RunBeginning> beginning;
    if (take) {
        beginning = valueOrRaise(beginningInTake(*scene, *take, time));
    } else if (time != 0.0) {
        throw ScriptError("time is a moment of a take: say of which, as in take=\"Rehearsal\".");
    }
    auto session = std::make_shared<ScriptSession>(scene, isRecorded, std::move(beginning));
    upToDate(*session);
    return session;
}

/// What a question without arguments answers: others may be at a step meanwhile.
template<class Answer>
auto asked(Answer (ScriptSession::*question)() const)
{
    return [question](const ScriptSession& session) {
        return outsidePython([&] { return (session.*question)(); });
    };
}

CrowdFramePtr frameOf(ScriptSession& session)
{
    upToDate(session);
    return outsidePython([&] { return session.frame(); });
}

void makeSteps(ScriptSession& session, std::int64_t count)
{
    if (count < 0) {
        throw ScriptError("count is the number of steps, 0 or more.");
    }
    upToDate(session);
    for (std::int64_t i = 0; i < count; ++i) {
        outsidePython([&] { session.step(); });
        raiseSignals();
    }
}

/// With what was edited since: the pose that is kept goes into the scene as it is.
int keepPose(ScriptSession& session)
{
    upToDate(session);
    const ScriptSession::Pose now = outsidePython([&] { return session.pose(); });
    ScriptScene::Snapshot after;
    const int people =
        valueOrRaise(keepPose(*session.scene(), now.shown->population, *now.pose, after));
    outsidePython([&] { session.adoptKept(after); });
    return people;
}

void runFor(ScriptSession& session, double seconds)
{
    constexpr double kMost = 1e6;
    if (!(seconds >= 0.0 && seconds <= kMost)) {
        throw ScriptError("seconds is from 0 to 1 000 000.");
    }
    makeSteps(session, std::llround(seconds * session.stepsPerSecond()));
}

std::uint8_t tagNamed(const Scene& scene, const std::variant<int, std::string>& tag)
{
    constexpr int kTags = 64;
    if (const int* bit = std::get_if<int>(&tag)) {
        if (*bit < 0 || *bit >= kTags) {
            throw ScriptError("A tag is a number from 0 to 63 or the name of one.");
        }
        return static_cast<std::uint8_t>(*bit);
    }
    const auto& name = std::get<std::string>(tag);
    const auto found = std::ranges::find(scene.tags, name, &TagName::name);
    if (found == scene.tags.end()) {
        throw ScriptError("There is no tag \"" + name + "\" in the scene.");
    }
    return found->bit;
}

void sendEvent(ScriptSession& session, const std::string& event, const py::object& ids,
               float number)
{
    upToDate(session);
    const ScriptEvent made = eventOf(*session.scene(), event, ids, number);
    outsidePython([&] { session.send(made.name, made.number, made.ids); });
}

void sendTagged(ScriptSession& session, const std::string& event,
                const std::variant<int, std::string>& tag, float number)
{
    upToDate(session);
    const ScriptEvent made = eventOf(*session.scene(), event, py::none(), number);
    const std::uint8_t bit = tagNamed(*session.scene()->scene(), tag);
    outsidePython([&] { session.sendTagged(made.name, made.number, bit); });
}

StateRecall recallGiven(ScriptSession& session, const std::string& name, float seconds,
                        const std::optional<Stagger>& stagger, const py::object& ids,
                        const std::optional<std::vector<std::string>>& columns)
{
    upToDate(session);
    const RecallOrder order = recallOrderOf(*session.scene(), seconds, stagger, ids, columns);
    const ChangeOver change = valueOrRaise(changeOverTo(*session.scene()->scene(), name, order));
    return outsidePython([&] { return session.recall(change); });
}

py::list takeLog(ScriptSession& session)
{
    py::list log;
    const auto taken = outsidePython([&] { return session.takeLog(); });
    for (const behavior::RuleFired& fired : taken) {
        log.append(py::make_tuple(fired.seconds, fired.rule, fired.who));
    }
    return log;
}

/// Everybody after the last step.
ScriptPicture requestOf(ScriptSession& session, int width, int height, bool isTransparent)
{
    const CrowdFramePtr frame = frameOf(session);
    ScriptPicture request;
    request.size = {width, height};
    request.seconds = frame->seconds;
    request.frame = frame;
    request.isTransparent = isTransparent;
    return request;
}

py::object pictureNow(ScriptSession& session, int width, int height, const CameraKey& camera,
                      const std::string& look, const std::string& by, std::optional<double> focus,
                      std::optional<double> fStop, bool isTransparent)
{
    LongCall call({});
    return pictureOf(*session.scene(), requestOf(session, width, height, isTransparent), camera,
                     {{look, by, cameraName(camera)}, {focus, fStop}}, call);
}

py::dict passesNow(ScriptSession& session, int width, int height,
                   const std::vector<std::string>& names, const CameraKey& camera,
                   const std::string& look, const std::string& by,
                   const std::optional<FilePath>& path, bool isTransparent)
{
    LongCall call({});
    ScriptPicture request = requestOf(session, width, height, isTransparent);
    request.passes = passesNamed(names);
    if (needAny(request.passes, PassNeed::Motion)) {
        request.frameSeconds = 1.0 / session.stepsPerSecond();
        request.frameBefore = outsidePython([&] { return session.frameBefore(); });
        if (!request.frameBefore) {
            throw ScriptError("Motion is that of the last step: make the session with "
                              "record=True, and a step.");
        }
    }
    return passesOf(*session.scene(), std::move(request), camera,
                    {{look, by, cameraName(camera)}, {}}, path, call);
}

void bindTime(SessionClass& session)
{
    session
        .def(py::init(&makeSession), py::arg("scene"), py::kw_only(), py::arg("record") = false,
             py::arg("take") = py::none(), py::arg("time") = 0.0,
             "Begins where the scene is now, or with people as they are in a kept take of that "
             "name at that time: with the rules and paths of now, which begin anew. Where there "
             "are stages and somebody walks, what can be walked on is found first, which takes "
             "seconds. record: its steps are kept, for keep_take, after those of the take until "
             "then.")
        .def_property_readonly(
            "scene", [](const ScriptSession& s) { return s.scene(); }, "That it runs.")
        .def("step", &makeSteps, py::arg("count") = 1,
             "So many steps on, each as long as the scene says (1/30 s where it says nothing).")
        .def("run", &runFor, py::arg("seconds"), "So long on, in whole steps.")
        .def_property_readonly("seconds", asked(&ScriptSession::seconds),
                               "That it has run, after the time of the take that it began in.")
        .def_property_readonly("steps", asked(&ScriptSession::steps), "That it has made.");
}

void bindEvents(SessionClass& session)
{
    session
        .def("send", &sendEvent, py::arg("event"), py::arg("ids") = py::none(), py::kw_only(),
             py::arg("number") = 0.0F,
             "An event happens at the next step: to these, or to everybody. Raises Error for ids "
             "that are dead, an empty name and a number that is not finite.")
        .def("send_tagged", &sendTagged, py::arg("event"), py::arg("tag"), py::kw_only(),
             py::arg("number") = 0.0F,
             "To those who have a tag at that time; tag: its name, or its number from 0 to 63.")
        .def("recall_state", &recallGiven, py::arg("name"), py::arg("seconds") = 0.0F,
             py::arg("stagger") = py::none(), py::arg("ids") = py::none(), py::kw_only(),
             py::arg("columns") = py::none(),
             "As Scene.recall_state, but in this session alone: the scene stays as it is. What an "
             "edit of the scene sets later counts again.")
        .def_property_readonly(
            "fired", asked(&ScriptSession::fired),
            "How often each rule has fired, by its id; those that have not are left out.")
        .def("take_log", &takeLog,
             "(seconds, rule's id, individual's id) of what fired since the last call, at most "
             "some thousand.")
        .def_property_readonly("problems", asked(&ScriptSession::problems),
                               "What could not be followed or came to grief, in sentences.");
}

py::array_t<bool> presentOf(ScriptSession& session)
{
    upToDate(session);
    const auto present = outsidePython([&] { return session.present(); });
    py::array_t<bool> array(static_cast<py::ssize_t>(present.size()));
    std::ranges::transform(present, array.mutable_data(), [](auto each) { return each != 0; });
    return array;
}

/// The frame's path is the one that somebody began with.
py::array columnOf(ScriptSession& session, const std::string& name)
{
    if (name != columnInfo(ColumnId::Path).name) {
        return columnArray(frameOf(session)->population, name);
    }
    upToDate(session);
    const auto paths = outsidePython([&] { return session.paths(); });
    return py::array_t<PathId>(static_cast<py::ssize_t>(paths.size()), paths.data());
}

void bindPeople(SessionClass& session)
{
    session.def("__len__", [](ScriptSession& s) { return frameOf(s)->population.size(); })
        .def_property_readonly(
            "ids", [](ScriptSession& s) { return columnArray(frameOf(s)->population, "id"); },
            "N uint32, ascending: everybody, also who has left.")
        .def_property_readonly(
            "present", &presentOf,
            "N bool, in the order of ids: whether each is still there. Who has left, at an exit or "
            "by a rule, stays in ids and columns, 100 000 m below the ground.")
        .def("column", &columnOf, py::arg("name"),
             "As Scene.column, but as everybody is after the last step; path: the one that each "
             "follows now, which is another after a branch or a rule's action, and 0 for those "
             "who have left.")
        .def("keep_pose", &keepPose,
             "Where everybody is now becomes where the scene has them: one undo step. How many "
             "people stand or sit another way than before.")
        .def("render", &pictureNow, py::arg("width"), py::arg("height"), py::kw_only(),
             py::arg("camera") = CameraKey(), py::arg("look") = "", py::arg("by") = "",
             py::arg("focus") = py::none(), py::arg("f_stop") = py::none(),
             py::arg("transparent") = false,
             "As Scene.render, but as everybody is after the last step.")
        .def("render_passes", &passesNow, py::arg("width"), py::arg("height"), py::arg("passes"),
             py::kw_only(), py::arg("camera") = CameraKey(), py::arg("look") = "",
             py::arg("by") = "", py::arg("path") = py::none(), py::arg("transparent") = false,
             "As Scene.render_passes, but as everybody is after the last step; motion is that of "
             "the last step, of a session with record=True.");
}

} // namespace

ScriptEvent eventOf(const ScriptScene& scene, const std::string& name, const py::object& ids,
                    float number)
{
    if (name.empty()) {
        throw ScriptError("An event needs a name.");
    }
    if (!std::isfinite(number)) {
        throw ScriptError("The number of event \"" + name + "\" is not finite.");
    }
    ScriptEvent event{name, number, {}};
    if (ids.is_none()) {
        const auto now = scene.scene();
        const auto all = now->population.ids();
        event.ids.assign(all.begin(), all.end());
        return event;
    }
    std::vector<std::size_t> order;
    event.ids = idsFrom(scene, ids, order);
    valueOrRaise(checkAlive(*scene.scene(), event.ids));
    return event;
}

void bindSession(py::module_& module)
{
    SessionClass session(module, "Session",
                         "A run of the simulation: people walk, rules fire. Never changes the "
                         "scene by itself; edits of the scene reach it at its next step. The same "
                         "scene, edits, events and steps give the same crowd.");
    bindTime(session);
    bindEvents(session);
    bindPeople(session);
    bindTakeKeeping(session);
}

} // namespace crowd::app
