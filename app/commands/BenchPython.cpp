// SPDX-License-Identifier: MIT
#include "app/commands/BenchPython.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iostream>
#include <vector>

#include "app/commands/BenchReport.h"
#include "app/python/Binding.h"
#include "app/python/EmbeddedPython.h"
#include "app/python/PythonBrush.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "model/document/SceneEdit.h"
#include "model/population/Properties.h"

namespace crowd::app {

using namespace model;

namespace {

/// Both sides get the same arrays and paint the same way.
constexpr const char* kScript = R"(
import numpy as np
import crowdbrush

COLUMNS = ("position", "heading", "height", "girth", "tint", "clip", "phase", "speed")
READ = ("id", "template", "position", "heading", "height", "girth", "tint", "choices", "parts",
        "clip", "phase", "speed", "seat", "tags", "group", "seed")

def arrays(count):
    draw = np.random.default_rng(1)
    side = int(np.ceil(np.sqrt(count)))
    place = np.arange(count)
    unit = lambda: draw.random(count, dtype=np.float32)
    return {
        "position": np.column_stack([1.1 * (place % side - side / 2), 0 * place,
                                     -1.1 * (place // side)]).astype(np.float32),
        "heading": 6.28 * unit(), "height": 0.9 + 0.2 * unit(), "girth": 0.9 + 0.2 * unit(),
        "tint": draw.integers(0, 256, (count, 8, 4), dtype=np.uint8),
        "clip": draw.integers(0, 3, count, dtype=np.uint16),
        "phase": unit(), "speed": 0.5 + unit()}

def new_scene():
    scene = crowdbrush.Scene()
    return scene, scene.add_template("builtin:templates/man.glb")

def create_and_read(scene, man, columns):
    scene.create(template=man, **columns)
    return [scene.column(name) for name in READ]

def brush():
    made = crowdbrush.Brush(crowdbrush.BrushKind.COLOUR)
    made.selection = crowdbrush.Selection.ALL_IN_CIRCLE
    made.operator = crowdbrush.Operator.RANDOM
    return made

def points():
    rows = [(265 + 10 * (c if r % 2 == 0 else 74 - c), 330 + 80 * r) for r in range(2) for c in range(75)]
    return np.array([(x, y, 1.0, i / 60, i / 60) for i, (x, y) in enumerate(rows)])

camera = crowdbrush.Camera((0, 12, 10), (0, 0, -15))

def paint(scene, made, rows):
    return scene.stroke(made, rows, camera=camera, size=(1280, 720), seed=1)
)";

constexpr int kPainted = 10'000;

template<class Work>
double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

struct Pair
{
    std::vector<double> python;
    std::vector<double> cpp;
};

void put(QJsonObject& report, const char* name, const Pair& times)
{
    const QString key = QLatin1String(name);
    report[key + QStringLiteral("_python_ms")] = rounded(median(times.python));
    report[key + QStringLiteral("_cpp_ms")] = rounded(median(times.cpp));
    report[key + QStringLiteral("_ratio")] = rounded(median(times.python) / median(times.cpp));
}

/// The arrays as C++ has them: a vector for each column.
std::vector<std::pair<ColumnId, std::vector<std::byte>>> vectorsOf(const py::dict& arrays)
{
    std::vector<std::pair<ColumnId, std::vector<std::byte>>> vectors;
    for (const auto& [key, value] : arrays) {
        const auto name = key.cast<std::string>();
        const auto array = value.cast<py::array>();
        const auto* from = static_cast<const std::byte*>(array.data());
        if (name == "tint") {
            const auto count = static_cast<std::size_t>(array.shape(0));
            for (std::size_t slot = 0; slot < 8; ++slot) {
                std::vector<std::byte> bytes(count * sizeof(Tint));
                for (std::size_t i = 0; i < count; ++i) {
                    std::memcpy(&bytes[i * sizeof(Tint)], from + (i * 8 + slot) * sizeof(Tint),
                                sizeof(Tint));
                }
                vectors.emplace_back(columns::tint(static_cast<int>(slot)).id, std::move(bytes));
            }
            continue;
        }
        if (const PropertyInfo* property = findProperty(name)) {
            vectors.emplace_back(property->id, std::vector<std::byte>(from, from + array.nbytes()));
        }
    }
    return vectors;
}

/// What a C++ program does with the engine: rows from vectors, one undo step, copies of all
/// columns.
std::size_t createAndRead(SceneDocument& document, std::size_t count,
                          const std::vector<std::pair<ColumnId, std::vector<std::byte>>>& vectors)
{
    IndividualRows rows = IndividualRows::withDefaults(std::vector<IndividualId>(count));
    std::ranges::fill(rows.column(columns::templateId), TemplateId{1});
    for (const auto& [column, bytes] : vectors) {
        rows.bytes[static_cast<std::size_t>(column)] = bytes;
    }
    document.edit(QStringLiteral("Create"),
                  [&](model::SceneEdit& edit) { edit.addIndividuals(std::move(rows)); });
    std::size_t read = 0;
    const Population& people = document.scene().population;
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const auto bytes = people.columnBytes(static_cast<ColumnId>(c));
        const std::vector<std::byte> copy(bytes.begin(), bytes.end());
        read += copy.size();
    }
    const std::vector<IndividualId> ids(people.ids().begin(), people.ids().end());
    return read + ids.size();
}

Pair columnTimes(const py::dict& names, int count, int rounds)
{
    const py::dict arrays = names["arrays"](count);
    const auto made = names["new_scene"]().cast<py::tuple>();
    const auto vectors = vectorsOf(arrays);
    SceneDocument document;
    document.replaceScene(*made[0].cast<ScenePtr>()->scene(), {});
    Pair times;
    for (int round = 0; round < rounds; ++round) {
        times.cpp.push_back(millisecondsOf(
            [&] { (void)createAndRead(document, static_cast<std::size_t>(count), vectors); }));
        document.undoStack().undo();
        py::object kept;
        times.python.push_back(
            millisecondsOf([&] { kept = names["create_and_read"](made[0], made[1], arrays); }));
        made[0].attr("undo")();
    }
    return times;
}

RecordedStroke recordedOf(const py::dict& names)
{
    RecordedStroke recorded;
    recorded.settings = names["brush"]().cast<const PythonBrush&>().settings();
    recorded.seed = 1;
    recorded.camera = names["camera"].cast<Camera>();
    recorded.viewSize = {1280.0F, 720.0F};
    const auto rows = names["points"]().cast<py::array_t<double>>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        PointerInput input =
            PointerInput::at({rows.at(i, 0), rows.at(i, 1)}, rows.at(i, 3), rows.at(i, 4));
        input.buttons = LeftButton;
        recorded.inputs.push_back(input);
    }
    return recorded;
}

Result<Pair> strokeTimes(const py::dict& names, int rounds)
{
    const auto made = names["new_scene"]().cast<py::tuple>();
    names["create_and_read"](made[0], made[1], names["arrays"](kPainted));
    const py::object brush = names["brush"]();
    const py::object points = names["points"]();
    const py::object paint = names["paint"];
    SceneDocument document;
    document.replaceScene(*made[0].cast<ScenePtr>()->scene(), {});
    KeyframeStore keyframes(std::size_t{2} << 30U);
    const StageRays stage;
    const RecordedStroke recorded = recordedOf(names);
    (void)replay(document, keyframes, stage, recorded); // asks for the clips
    keyframes.waitForAll();
    document.undoStack().undo();
    paint(made[0], brush, points);
    made[0].attr("undo")();
    Pair times;
    for (int round = 0; round < rounds; ++round) {
        StrokeOutcome ours;
        times.cpp.push_back(
            millisecondsOf([&] { ours = replay(document, keyframes, stage, recorded); }));
        document.undoStack().undo();
        py::object theirs;
        times.python.push_back(millisecondsOf([&] { theirs = paint(made[0], brush, points); }));
        made[0].attr("undo")();
        if (ours.affected == 0 || theirs.attr("affected").cast<int>() != ours.affected) {
            return Error{"The stroke of the script is not the one in C++."};
        }
    }
    return times;
}

Result<QJsonObject> measure(const BenchPythonOptions& options)
{
    try {
        py::dict names;
        py::exec(kScript, names);
        QJsonObject report;
        report[QStringLiteral("count")] = options.count;
        report[QStringLiteral("rounds")] = options.rounds;
        put(report, "columns", columnTimes(names, options.count, options.rounds));
        const auto strokes = strokeTimes(names, options.rounds);
        if (!strokes) {
            return strokes.error();
        }
        report[QStringLiteral("painted")] = kPainted;
        put(report, "stroke", strokes.value());
        return report;
    } catch (const py::error_already_set& problem) {
        return Error{problem.what()};
    }
}

} // namespace

int runBenchPython(const BenchPythonOptions& options)
{
    const EmbeddedPython python(true);
    const auto report = measure(options);
    if (!report) {
        std::cerr << report.error().message << '\n';
        return 1;
    }
    if (options.json) {
        std::cout << QJsonDocument(report.value()).toJson(QJsonDocument::Compact).toStdString()
                  << '\n';
        return 0;
    }
    for (const QString& name : report.value().keys()) {
        std::cout << name.toStdString() << ": " << report.value()[name].toDouble() << '\n';
    }
    return 0;
}

} // namespace crowd::app
