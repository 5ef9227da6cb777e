// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <string_view>
#include <thread>

#include <pybind11/eval.h>
#include <pybind11/operators.h>

#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/StraightAlpha.h"
#include "app/python/Binding.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "app/python/ScriptEnvironment.h"
#include "behavior/session/SceneMotion.h"
#include "model/describe/FieldChecks.h"
#include "model/project/LocateAssets.h"
#include "model/view/CameraTrack.h"
#include "model/view/PropertyPaint.h"

namespace crowd::app {

using namespace model;

glm::vec3 toVector(const Point3& point, const char* name)
{
    constexpr float kFarthest = 1e9F;
    for (const float each : point) {
        if (!(std::abs(each) <= kFarthest)) {
            throw ScriptError(std::string(name) +
                              " must hold three finite numbers, at most 1000000000 away.");
        }
    }
    return {point[0], point[1], point[2]};
}

std::optional<std::string> cameraName(const CameraKey& key)
{
    if (const auto* name = std::get_if<std::string>(&key)) {
        return *name;
    }
    return std::holds_alternative<Camera>(key) ? std::nullopt : std::optional<std::string>("");
}

std::optional<Camera> cameraOf(const ScriptScene& scene, const CameraKey& key)
{
    if (const auto* name = std::get_if<std::string>(&key)) {
        return valueOrRaise(cameraNamed(scene, *name));
    }
    if (const auto* camera = std::get_if<Camera>(&key)) {
        return *camera;
    }
    return std::nullopt;
}

namespace {

Camera makeCamera(const Point3& from, const Point3& at, float fovDegrees)
{
    const glm::vec3 eye = toVector(from, "position");
    const glm::vec3 target = toVector(at, "target");
    if (glm::length(target - eye) < 1e-6F) {
        throw ScriptError("A camera's position and target must differ.");
    }
    if (!(fovDegrees >= 1.0F && fovDegrees <= 170.0F)) {
        throw ScriptError("fov is in degrees, from 1 to 170.");
    }
    Camera camera = Camera::lookingAt(eye, target);
    camera.fovYRadians = glm::radians(fovDegrees);
    return camera;
}

} // namespace

void refuseMissing(const Scene& scene)
{
    const std::vector<std::string> missing = missingFromPictures(scene);
    if (missing.empty()) {
        return;
    }
    std::string all;
    for (const std::string& each : missing) {
        all += "\nMissing: " + each;
    }
    throw ScriptError("The picture would lack something: change the templates and stages so that "
                      "they are found, or render with allow_missing=True." +
                      all);
}

namespace {

void refuseTime(double time)
{
    if (!(std::abs(time) <= behavior::kMostSceneSeconds)) {
        throw ScriptError("time is " + std::string(py::str(py::float_(time))) +
                          "; it must be from -604800 to 604800 seconds, a week.");
    }
}

/// Height × width, and × the number of channels where there are several.
py::object arrayOf(const ExrLayer& layer, const glm::ivec2& size)
{
    const auto count = static_cast<py::ssize_t>(layer.channels.size());
    if (const auto* ids = std::get_if<std::vector<std::uint32_t>>(&layer.channels[0].values)) {
        return py::array_t<std::uint32_t>({size.y, size.x}, ids->data());
    }
    std::vector<py::ssize_t> shape{size.y, size.x};
    if (count > 1) {
        shape.push_back(count);
    }
    py::array_t<float> array(shape);
    for (py::ssize_t channel = 0; channel < count; ++channel) {
        const auto& values =
            std::get<std::vector<float>>(layer.channels[static_cast<std::size_t>(channel)].values);
        float* to = array.mutable_data() + channel;
        for (const float value : values) {
            *to = value;
            to += count;
        }
    }
    return array;
}

} // namespace

PicturePasses passesNamed(const std::vector<std::string>& names)
{
    if (names.empty()) {
        throw ScriptError("passes names nothing. There are: " + passKeys() + ".");
    }
    std::string keys;
    for (const std::string& name : names) {
        keys += (keys.empty() ? "" : ",") + name;
    }
    return valueOrRaise(passesOf(keys));
}

py::dict passesOf(ScriptScene& scene, ScriptPicture request, const CameraKey& camera,
                  const PictureKey& look, const std::optional<FilePath>& path, LongCall& call)
{
    const PicturePasses passes = request.passes;
    const glm::ivec2 size = request.size;
    const bool isTransparent = request.isTransparent;
    const ScriptDrawing drawn = drawingOf(scene, std::move(request), camera, look, call);
    if (path) {
        valueOrRaise(
            writePasses(QString::fromStdString(path->string()),
                        {passes, drawn.layers, drawn.header, drawn.pixels, isTransparent}));
    }
    py::dict arrays;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        arrays[py::str(std::string(passes[i]->key))] = arrayOf(drawn.layers[i], size);
    }
    return arrays;
}

namespace {

py::dict renderPasses(const ScenePtr& scene, int width, int height,
                      const std::vector<std::string>& names, const CameraKey& camera, double time,
                      const std::string& look, const std::string& by,
                      const std::optional<FilePath>& path, bool isTransparent, bool allowsMissing,
                      const LongCall::Listener& progress)
{
    refuseTime(time);
    if (!allowsMissing) {
        refuseMissing(*scene->scene());
    }
    LongCall call(progress);
    ScriptPicture request;
    request.size = {width, height};
    request.seconds = time;
    request.passes = passesNamed(names);
    request.isTransparent = isTransparent;
    return passesOf(*scene, std::move(request), camera, {{look, by, cameraName(camera)}, {}}, path,
                    call);
}

py::object picture(const ScenePtr& scene, int width, int height, const CameraKey& camera,
                   double time, const std::string& look, const std::string& by,
                   std::optional<double> focus, std::optional<double> fStop, bool isTransparent,
                   bool allowsMissing, const LongCall::Listener& progress)
{
    refuseTime(time);
    if (!allowsMissing) {
        refuseMissing(*scene->scene());
    }
    LongCall call(progress);
    ScriptPicture request;
    request.size = {width, height};
    request.seconds = time;
    request.isTransparent = isTransparent;
    return pictureOf(*scene, std::move(request), camera,
                     {{look, by, cameraName(camera)}, {focus, fStop}}, call);
}

/// Red, green and blue by alpha, or the other way round; each is 255 at most.
void savePicture(const FilePath& path, const py::array_t<std::uint8_t, py::array::c_style>& array,
                 bool isTransparent)
{
    if (array.ndim() != 3 || array.shape(2) != 4) {
        throw ScriptError("A picture is an array of height × width × 4.");
    }
    std::vector<std::uint8_t> pixels(array.data(), array.data() + array.size());
    if (isTransparent) {
        multiplyAlpha(pixels);
    }
    valueOrRaise(writePicture(QString::fromStdString(path.string()), pixels,
                              {static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))},
                              isTransparent));
}

/// A picture is an array that can save itself; a subclass of NumPy's is shortest in Python.
void bindPicture(py::module_& module)
{
    module.def("_save_png", &savePicture);
    py::exec(R"(
import numpy as _numpy

class Picture(_numpy.ndarray):
    """A picture: height × width × 4 uint8, red, green, blue, alpha, sRGB, rows from the top."""

    def __new__(cls, pixels: "Array") -> "Picture":
        return _numpy.asarray(pixels).view(cls)

    def save_png(self, path: "FilePath", transparent: bool = False) -> None:
        """Writes the picture to a file, whole or not at all; with its alpha where transparent."""
        _save_png(str(path), _numpy.ascontiguousarray(self, dtype=_numpy.uint8), transparent)
)",
             module.attr("__dict__"));
}

Camera exactCamera(const Point3& position, const std::array<float, 4>& orientation,
                   bool isOrthographic, float fovRadians, float height, float pivotDistance)
{
    Camera camera;
    camera.position = toVector(position, "position");
    camera.orientation = {orientation[0], orientation[1], orientation[2], orientation[3]};
    camera.projection = isOrthographic ? Projection::Orthographic : Projection::Perspective;
    camera.fovYRadians = fovRadians;
    camera.orthographicHeight = height;
    camera.pivotDistance = pivotDistance;
    for (const FieldInfo& field : fieldsOf<Camera>()) {
        const std::string_view key = field.meta.key;
        const std::string name = key == "fovY"                 ? "fov_radians"
                                 : key == "orthographicHeight" ? "height"
                                                               : attributeOf(key);
        valueOrRaise(checkField(field, field.get(&camera), name));
    }
    return camera;
}

/// All of a camera, bit by bit: what exact() takes.
py::tuple stateOf(const Camera& camera)
{
    const glm::quat& q = camera.orientation;
    return py::make_tuple(Point3{camera.position.x, camera.position.y, camera.position.z},
                          std::array<float, 4>{q.w, q.x, q.y, q.z},
                          camera.projection == Projection::Orthographic, camera.fovYRadians,
                          camera.orthographicHeight, camera.pivotDistance);
}

Camera cameraOfState(const py::tuple& state)
{
    constexpr std::size_t kParts = 6;
    if (state.size() != kParts) {
        throw ScriptError("This was pickled by another version of Crowdbrush.");
    }
    return exactCamera(state[0].cast<Point3>(), state[1].cast<std::array<float, 4>>(),
                       state[2].cast<bool>(), state[3].cast<float>(), state[4].cast<float>(),
                       state[5].cast<float>());
}

void bindCamera(py::module_& module)
{
    py::class_<Camera>(module, "Camera", "Where a picture is taken from. World frame, metres.")
        .def(py::init(&makeCamera), py::arg("position"), py::arg("target"), py::arg("fov") = 45.0F,
             "Looks from position to target, metres. fov: vertical, degrees.")
        .def_static("exact", &exactCamera, py::arg("position"), py::arg("orientation"),
                    py::kw_only(), py::arg("orthographic") = false, py::arg("fov_radians") = 0.8F,
                    py::arg("height") = 20.0F, py::arg("pivot_distance") = 12.0F,
                    "Just as the editor holds it: orientation is a quaternion (w, x, y, z) of a "
                    "view along -Z with Y up; height: metres from bottom to top, orthographic; "
                    "pivot_distance: to the point that orbiting turns around.")
        .def_property_readonly(
            "position",
            [](const Camera& camera) {
                return Point3{camera.position.x, camera.position.y, camera.position.z};
            })
        .def_property_readonly("target",
                               [](const Camera& camera) {
                                   const glm::vec3 pivot = camera.pivot();
                                   return Point3{pivot.x, pivot.y, pivot.z};
                               })
        .def_property_readonly(
            "orientation",
            [](const Camera& camera) {
                const glm::quat& q = camera.orientation;
                return std::array<float, 4>{q.w, q.x, q.y, q.z};
            },
            "Quaternion (w, x, y, z).")
        .def_property_readonly(
            "orthographic",
            [](const Camera& camera) { return camera.projection == Projection::Orthographic; })
        .def_readonly("fov_radians", &Camera::fovYRadians, "Vertical.")
        .def_readonly("height", &Camera::orthographicHeight, "Metres, orthographic.")
        .def_readonly("pivot_distance", &Camera::pivotDistance, "Metres.")
        .def(py::self == py::self)
        .def(py::pickle(&stateOf, &cameraOfState));
}

/// Another thread may be at one, which lets Python's other threads run.
void waitForPictures(const ScriptScene& scene)
{
    constexpr std::chrono::milliseconds kPause{5};
    while (scene.pictures().drawingThread() != std::thread::id()) {
        if (scene.pictures().drawingThread() == std::this_thread::get_id()) {
            throw ScriptError("A picture of this scene is being drawn: draw the next one when it "
                              "is done.");
        }
        outsidePython([&] { std::this_thread::sleep_for(kPause); });
        raiseSignals();
    }
}

/// Without a camera it is the timeline's, with its look.
void takeCamera(const ScriptScene& scene, const CameraKey& key, ScriptPicture& request,
                LookWish& wish)
{
    const auto now = scene.scene();
    request.camera = cameraOf(scene, key);
    CameraTrack track(*now);
    if (!request.camera && track.hasMoves()) {
        const DirectedCamera directed = track.at(request.seconds);
        request.camera = directed.camera;
        wish.directed = directed.look;
    } else {
        request.camera = valueOrRaise(cameraOrFirst(*now, request.camera));
        track = CameraTrack(DirectedCamera{*request.camera, {}, 0});
    }
    if (needAny(request.passes, PassNeed::Motion)) {
        const double before =
            std::min(std::max(request.seconds - request.frameSeconds, 0.0), request.seconds);
        request.before = {before, track.before(before, request.seconds).camera};
    }
}

} // namespace

ScriptDrawing drawingOf(ScriptScene& scene, ScriptPicture request, const CameraKey& camera,
                        const PictureKey& look, LongCall& call)
{
    constexpr int kMost = 16384;
    const glm::ivec2 size = request.size;
    if (size.x < 1 || size.y < 1 || size.x > kMost || size.y > kMost) {
        throw ScriptError("A picture is 1 to 16384 pixels wide and high.");
    }
    LookWish wish = look.look;
    takeCamera(scene, camera, request, wish);
    request.look = valueOrRaise(chosenLook(wish, *scene.scene()));
    request.lens = look.lens;
    constexpr double kSimulated = 0.9; // the rest is drawn
    request.patience = [&call](Waiting& waiting, const std::function<void()>& work) {
        mindingSignals(waiting.isCancelled, work,
                       [&] { return call.hook()(kSimulated * waiting.share); });
        call.raise();
    };
    request.keepGoing = [&call](double share) {
        return call.hook()(kSimulated + (1.0 - kSimulated) * share);
    };
    waitForPictures(scene);
    auto drawn = scene.pictures().picture(scene, request);
    call.raise(); // what stopped it says more than that it was
    ScriptDrawing drawing = valueOrRaise(std::move(drawn));
    (void)call.hook()(1.0);
    call.raise();
    return drawing;
}

py::object pictureOf(ScriptScene& scene, ScriptPicture request, const CameraKey& camera,
                     const PictureKey& look, LongCall& call)
{
    const glm::ivec2 size = request.size;
    const bool isTransparent = request.isTransparent;
    ScriptDrawing drawn = drawingOf(scene, std::move(request), camera, look, call);
    if (isTransparent) {
        straightenAlpha(drawn.pixels);
    }
    const py::array_t<std::uint8_t> array({size.y, size.x, 4}, drawn.pixels.data());
    return callPython(py::module_::import("crowdbrush").attr("Picture"), py::make_tuple(array));
}

namespace {

Camera cameraAt(const ScriptScene& scene, double seconds)
{
    refuseTime(seconds);
    const auto now = scene.scene();
    const CameraTrack track(*now);
    return track.hasMoves() ? track.at(seconds).camera
                            : valueOrRaise(cameraOrFirst(*now, std::nullopt));
}

std::string passesDoc()
{
    std::string doc =
        "What the picture shows, in numbers for compositing: by the name of each of "
        "the passes an array, height × width, × the components where there are "
        "several, float32 or uint32, rows from the top. path: an .exr file that they "
        "are written to as well, a layer each, or a .png, from which each has one of its own "
        "(a.depth.png), as whole numbers. Of each pixel it is what lies at its "
        "centre; glass of stages is seen through, and of people what hides less than half. "
        "There are";
    const char* comma = " ";
    for (const PicturePass& pass : picturePasses()) {
        doc += comma + std::string(pass.key) + " (" + pass.doc + ")";
        comma = "; ";
    }
    return doc + ". camera, time, look, by, transparent and allow_missing are as of "
                 "render. " CROWD_PROGRESS_DOC;
}

} // namespace

void bindPictures(py::module_& module, SceneClass& scene)
{
    bindCamera(module);
    bindPicture(module);
    scene.def(
        "render", &picture, py::arg("width"), py::arg("height"), py::kw_only(),
        py::arg("camera") = CameraKey(), py::arg("time") = 0.0, py::arg("look") = "",
        py::arg("by") = "", py::arg("focus") = py::none(), py::arg("f_stop") = py::none(),
        py::arg("transparent") = false, py::arg("allow_missing") = false,
        py::arg("progress") = py::none(),
        "The picture as height × width × 4 uint8. Needs no display. time: seconds, at most a "
        "week. camera: a name or a Camera; without one, as the timeline has it at that time, or "
        "the scene's first. look: one of the scene's by its name, or \"plain\", \"lit\", "
        "\"cartoon\" and the "
        "like; without it, as the camera has it, else lit. by: what people are coloured by, in the "
        "look \"property\": \"template\", "
        "\"group\", \"tag\", \"clip\", \"height\", \"density\", a property that is a number, or "
        "\"feature:KIND\". focus (metres from the camera; without it, what the camera turns "
        "around) and f_stop (the smaller, the less is sharp; 0.5 without it): depth of field, "
        "where either is given. transparent: alpha is 0 where neither people nor stages are. Where "
        "a "
        "stage, or a character of whom there is somebody, could not "
        "be "
        "loaded, it fails and says what is missing, unless allow_missing. " CROWD_PROGRESS_DOC);
    scene.def("camera_at", &cameraAt, py::arg("time"),
              "The camera as the timeline's marks have moved it by then: seconds of the clock. "
              "Without such marks it is the scene's first.");
    scene.def(
        "render_passes", &renderPasses, py::arg("width"), py::arg("height"), py::arg("passes"),
        py::kw_only(), py::arg("camera") = CameraKey(), py::arg("time") = 0.0, py::arg("look") = "",
        py::arg("by") = "", py::arg("path") = py::none(), py::arg("transparent") = false,
        py::arg("allow_missing") = false, py::arg("progress") = py::none(), passesDoc().c_str());
}

} // namespace crowd::app
