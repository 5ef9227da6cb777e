// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "app/python/PythonBrush.h"
#include "app/python/ScriptPainting.h"

namespace crowd::app {

using namespace model;

namespace {

/// Points as rows of x, y, then pressure, time, shown seconds; without times one each 1/60 s.
std::vector<PointerInput> inputsFrom(const py::object& points, double shownSeconds)
{
    const py::array given = arrayOf("points", points);
    const char kind = given.dtype().kind();
    const bool areNumbers = kind == 'i' || kind == 'u' || kind == 'f';
    using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
    const Rows rows = areNumbers ? Rows::ensure(given) : Rows();
    if (!areNumbers || !rows || rows.ndim() != 2 || rows.shape(0) == 0 || rows.shape(1) < 2 ||
        rows.shape(1) > 5) {
        PyErr_Clear();
        throw ScriptError("points must be an array of at least one row of x, y, optionally "
                          "pressure, optionally time, optionally the seconds that were shown.");
    }
    std::vector<PointerInput> inputs;
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        const auto at = [&](py::ssize_t k, double otherwise) {
            return k < rows.shape(1) ? rows.at(i, k) : otherwise;
        };
        const double seconds = at(3, static_cast<double>(i) / 60.0);
        const double pressure = at(2, 1.0);
        const double shown = at(4, shownSeconds);
        const glm::dvec2 pixels(at(0, 0.0), at(1, 0.0));
        constexpr double kFarthest = 1e6;
        constexpr double kLongest = 3600.0; // a hand paints all the while
        if (!inputs.empty() && seconds - inputs.front().timeSeconds > kLongest) {
            throw ScriptError("points[" + std::to_string(i) +
                              "] comes more than an hour after the first one: times are seconds, "
                              "and a brush paints all the while between them.");
        }
        if (!(std::abs(pixels.x) < kFarthest && std::abs(pixels.y) < kFarthest) ||
            !(pressure >= 0.0 && pressure <= 1.0) || !std::isfinite(seconds) ||
            !std::isfinite(shown) || (i > 0 && seconds < inputs.back().timeSeconds)) {
            throw ScriptError("points[" + std::to_string(i) +
                              "] must be finite, with a pressure from 0 to 1 and a time that does "
                              "not go back.");
        }
        PointerInput input = PointerInput::at(pixels, seconds, shown);
        input.pressure = static_cast<float>(pressure);
        input.buttons = LeftButton;
        inputs.push_back(input);
    }
    return inputs;
}

/// Whom each dab means, from a mapping of its number to ids.
std::vector<std::vector<IndividualId>> selectedFrom(const ScriptScene& scene,
                                                    const py::object& given)
{
    constexpr std::int64_t kMostDabs = 1'000'000;
    std::vector<std::vector<IndividualId>> selected;
    if (given.is_none()) {
        return selected;
    }
    if (!py::isinstance<py::dict>(given)) {
        throw ScriptError("selected must be a dict: the number of a dab, from 0, and the ids that "
                          "it means, as a recording has it.");
    }
    selected.resize(1); // an empty one means nobody
    for (const auto& [key, ids] : given.cast<py::dict>()) {
        const std::int64_t dab =
            py::isinstance<py::int_>(key) ? PyLong_AsLongLong(key.ptr()) : std::int64_t{-1};
        PyErr_Clear();
        if (dab < 0 || dab >= kMostDabs) {
            throw ScriptError("selected: " + py::repr(key).cast<std::string>() +
                              " is no number of a dab: they count from 0, up to " +
                              std::to_string(kMostDabs) + '.');
        }
        const auto at = static_cast<std::size_t>(dab);
        selected.resize(std::max(selected.size(), at + 1));
        std::vector<std::size_t> order;
        auto& meant = selected[at];
        meant = idsFrom(scene, py::reinterpret_borrow<py::object>(ids), order);
        meant.erase(std::unique(meant.begin(), meant.end()), meant.end());
    }
    return selected;
}

/// The editor's own brush as it is; one that a script brings along with the area that it asks for.
BrushSettings settingsOf(const ScenePtr& scene, const py::object& brush)
{
    if (py::isinstance<PythonBrush>(brush)) {
        const auto& given = brush.cast<const PythonBrush&>();
        if (given.kind == BrushKind::Script) {
            throw ScriptError("Give the brush itself, the object with apply(selection).");
        }
        if (!given.isKnownKind()) {
            throw ScriptError("brush.kind is none of the choices there are.");
        }
        const auto& owners = given.part<CreateSettings>().owners;
        if (given.kind == BrushKind::Create &&
            std::ranges::any_of(owners, [&](const auto& each) { return each.lock() != scene; })) {
            throw ScriptError("brush.create.mix holds a template of another scene: take those of "
                              "scene.templates, or add it here with add_template.");
        }
        return given.settings();
    }
    const py::module_ module = py::module_::import("crowdbrush");
    const py::tuple given = py::make_tuple(brush);
    (void)callPython(module.attr("_check"), given);
    const py::object area = callPython(module.attr("_area_of"), given);
    BrushSettings settings = area.cast<const PythonBrush&>().settings();
    settings.as<ScriptSettings>().brush =
        callPython(module.attr("_known_name"), given).cast<std::string>();
    return settings;
}

StrokeOutcome stroke(const ScenePtr& scene, const py::object& brush, const py::object& points,
                     const CameraKey& camera, const std::pair<float, float>& size,
                     std::uint64_t seed, double time, bool allowMissing, const py::object& selected,
                     const LongCall::Listener& progress)
{
    if (!(size.first >= 1.0F && size.second >= 1.0F && size.first <= 16384.0F &&
          size.second <= 16384.0F)) {
        throw ScriptError("size is a width and a height in pixels, from 1 to 16384.");
    }
    if (!std::isfinite(time)) {
        throw ScriptError("time must be a finite number of seconds.");
    }
    ScriptStroke request;
    request.settings = settingsOf(scene, brush);
    request.inputs = inputsFrom(points, time);
    request.camera = cameraOf(*scene, camera);
    request.viewSize = {size.first, size.second};
    request.seed = seed;
    request.allowsMissing = allowMissing;
    request.selected = selectedFrom(*scene, selected);
    if (!request.selected.empty() && request.settings.kind() == BrushKind::Create) {
        throw ScriptError("selected means people there are: a brush that creates has none.");
    }
    LongCall call(progress);
    const auto paint = [&](ScriptStrokeLink& dabs) {
        const py::module_ module = py::module_::import("crowdbrush");
        paintDabs(scene, dabs,
                  callPython(module.attr("_brush_with"), py::make_tuple(brush, py::dict())), &call);
    };
    auto outcome = paintStroke(*scene, request, paint, call.hook());
    call.raise();
    return valueOrRaise(std::move(outcome));
}

} // namespace

void bindStrokes(py::module_& module, SceneClass& scene)
{
    py::class_<StrokeOutcome>(module, "StrokeOutcome", "What a stroke did.")
        .def_readonly("committed", &StrokeOutcome::isCommitted, "Whether it made an undo step.")
        .def_readonly("affected", &StrokeOutcome::affected, "Created, removed or changed.")
        .def_property_readonly(
            "message", [](const StrokeOutcome& outcome) { return outcome.message.toStdString(); },
            "Why nothing happened; empty otherwise.");
    scene.def(
        "stroke", &stroke, py::arg("brush"), py::arg("points"), py::kw_only(),
        py::arg("camera") = CameraKey(), py::arg("size") = std::pair(1280.0F, 720.0F),
        py::arg("seed") = 1, py::arg("time") = 0.0, py::arg("allow_missing") = false,
        py::arg("selected") = py::none(), py::arg("progress") = py::none(),
        "Paints as the mouse does: points in logical pixels of a view of this size, "
        "rows of x, y[, pressure[, time[, shown]]]; one undo step. shown: the transport's time "
        "of what was on screen, for all of them with time=. Raises Error where "
        "the brush names a group, template, path or clip that the scene does not have, unless "
        "allow_missing: it paints all the same then, as the editor does. selected: whom each dab "
        "means, by its number, instead of those under it; recordings of strokes on people who "
        "were elsewhere while it played have it. " CROWD_PROGRESS_DOC);
}

} // namespace crowd::app
