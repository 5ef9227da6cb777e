// SPDX-License-Identifier: MIT
#include <algorithm>

#include <pybind11/eval.h>

#include "BrushesSource.h"
#include "app/python/Binding.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"

namespace crowd::app {

using namespace model;

namespace {

py::tuple toPair(glm::dvec2 point)
{
    return py::make_tuple(point.x, point.y);
}

/// Earlier dabs may have removed some.
py::array_t<IndividualId> present(const ScenePtr& scene, const std::vector<IndividualId>& ids)
{
    const auto now = scene->scene();
    std::vector<IndividualId> alive;
    for (const IndividualId id : ids) {
        if (now->population.rowOf(id) != Population::npos) {
            alive.push_back(id);
        }
    }
    return py::array_t<IndividualId>(static_cast<py::ssize_t>(alive.size()), alive.data());
}

/// Of all dabs; they are all there when a script paints.
double shareOf(const ScriptStrokeLink::Progress& progress)
{
    return static_cast<double>(progress.taken) /
           static_cast<double>(std::max(1, progress.taken + progress.waiting + 1));
}

/// The next dab; false: there are no more. Python's signals come through meanwhile.
bool nextDab(ScriptStrokeLink& dabs, ScriptDab& dab)
{
    while (true) {
        const ScriptStrokeLink::Wait got = outsidePython([&] { return dabs.next(dab); });
        raiseSignals();
        if (got != ScriptStrokeLink::Wait::Nothing) {
            return got == ScriptStrokeLink::Wait::Dab;
        }
    }
}

} // namespace

void paintDabs(const ScenePtr& scene, ScriptStrokeLink& dabs, const py::object& brush,
               LongCall* call)
{
    const py::module_ module = py::module_::import("crowdbrush");
    const py::object selected = module.attr("Selected");
    const py::object apply = module.attr("_apply");
    // A script may keep its selection longer than the stroke lasts.
    const py::cpp_function report([link = dabs.weak_from_this()](double share) {
        if (const auto still = link.lock()) {
            still->report(share);
        }
    });
    ScriptDab dab;
    while (nextDab(dabs, dab)) {
        const py::array_t<IndividualId> ids = present(scene, dab.ids);
        if (ids.size() > 0) {
            const py::object selection =
                callPython(selected, py::make_tuple(scene, ids, dab.seed, toPair(dab.line.from),
                                                    toPair(dab.line.to), dab.heading, report));
            (void)callPython(apply, py::make_tuple(brush, selection));
        }
        if (call != nullptr && !scene->ask(call->hook(), shareOf(dabs.progress()))) {
            call->raise();
        }
    }
}

void bindScriptBrushes(py::module_& module)
{
    py::exec(kBrushesSource, module.attr("__dict__"));
}

} // namespace crowd::app
