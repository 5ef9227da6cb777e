// SPDX-License-Identifier: MIT
#include "app/commands/BenchPaint.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "app/commands/BenchRelations.h"
#include "app/commands/BenchReport.h"
#include "app/commands/BenchStates.h"
#include "model/base/Random.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "model/gltf/GltfImport.h"
#include "model/pick/ScenePicker.h"
#include "model/project/AssetPaths.h"
#include "render/OffscreenContext.h"
#include "render/Renderer.h"

namespace crowd::app {

namespace {

using Clock = std::chrono::steady_clock;
using model::PointerInput;

constexpr glm::vec2 kPicture{1280.0F, 720.0F};
constexpr float kApartMetres = 1.1F;
constexpr float kRadiusPixels = 40.0F;
constexpr int kDabs = 150;
constexpr int kUndos = 5;
constexpr int kFrames = 4;
constexpr int kAreaQueries = 25;
constexpr int kPeopleInArea = 400;

/// With the settings of its struct.
model::BrushSettings brushOf(model::BrushKind kind)
{
    model::BrushSettings settings;
    settings.setKind(kind);
    return settings;
}

double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double percentile(std::vector<double> samples, double share)
{
    std::ranges::sort(samples);
    const auto last = static_cast<double>(samples.size() - 1);
    return samples[static_cast<std::size_t>(std::lround(share * last))];
}

model::Result<std::vector<model::TemplateEntry>> loadCast()
{
    std::vector<model::TemplateEntry> entries;
    for (const char* path : {"builtin:templates/man.glb", "builtin:templates/woman.glb"}) {
        auto asset = model::importTemplate(model::assetFile(path).toStdString());
        if (!asset) {
            return asset.error();
        }
        model::TemplateEntry entry;
        entry.id = static_cast<model::TemplateId>(entries.size() + 1);
        entry.name = asset.value()->name;
        entry.path = path;
        entry.asset = asset.value();
        for (const model::Clip& clip : entry.asset->clips) {
            entry.clipNames.push_back(clip.name);
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// Rows of the cast in turn at these foot points, each at a moment of its own.
model::IndividualRows peopleAt(const std::vector<glm::vec3>& places)
{
    auto rows =
        model::IndividualRows::withDefaults(std::vector<model::IndividualId>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        rows.column(model::columns::templateId)[i] = static_cast<model::TemplateId>(1 + i % 2);
        rows.column(model::columns::position)[i] = places[i];
        rows.column(model::columns::heading)[i] = 6.28F * model::unitFloat(model::hashKeys(i, 1));
        rows.column(model::columns::phase)[i] = model::unitFloat(model::hashKeys(i, 2));
    }
    return rows;
}

/// A square field seen from above its near edge.
std::vector<glm::vec3> fieldOf(int count)
{
    const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    std::vector<glm::vec3> places;
    for (int i = 0; i < count; ++i) {
        const int x = i % side;
        const int z = i / side;
        places.emplace_back(kApartMetres *
                                (static_cast<float>(x) - 0.5F * static_cast<float>(side)),
                            0.0F, -kApartMetres * static_cast<float>(z));
    }
    return places;
}

model::View fieldView()
{
    return {model::Camera::lookingAt({0.0F, 12.0F, 10.0F}, {0.0F, 0.0F, -15.0F}), kPicture};
}

model::View viewFromAbove(float metresHigh)
{
    model::Camera camera = model::Camera::lookingAt({0.0F, 100.0F, 0.0F}, glm::vec3(0.0F));
    camera.projection = model::Projection::Orthographic;
    camera.orthographicHeight = metresHigh;
    return {camera, kPicture};
}

struct StrokeTimes
{
    double pressMs = 0.0;
    std::vector<double> dabMs;
    int painted = 0;
};

struct AreaQueries
{
    double medianMs = 0.0;
    double candidates = 0.0; ///< looked at by each
};

/// One measurement: a document of people, its assets baked.
class PaintBench
{
public:
    PaintBench(std::vector<model::TemplateEntry> cast, const std::vector<glm::vec3>& places)
    {
        model::Scene scene;
        scene.templates = std::move(cast);
        m_document.replaceScene(std::move(scene), {});
        m_document.edit(QStringLiteral("People"),
                        [&](model::SceneEdit& edit) { edit.addIndividuals(peopleAt(places)); });
        for (const model::TemplateEntry& entry : m_document.scene().templates) {
            (void)m_keyframes.clip(entry.asset, 0);
        }
        m_keyframes.waitForAll();
    }

    [[nodiscard]] StrokeTimes paint(model::BrushSettings settings);
    [[nodiscard]] double medianUndo();
    [[nodiscard]] std::optional<double> medianFrame();
    [[nodiscard]] AreaQueries queryArea(model::AreaMode mode);
    /// Last: it changes people.
    void addStates(QJsonObject& report)
    {
        measureStates(m_document, report);
        measureRelations(m_document, report);
    }

private:
    [[nodiscard]] model::BrushContext context() { return {fieldView(), m_keyframes, m_stage}; }

    model::SceneDocument m_document;
    model::KeyframeStore m_keyframes;
    model::StageRays m_stage;
};

/// A stroke over everyone visible in the circle; each move is one dab.
StrokeTimes PaintBench::paint(model::BrushSettings settings)
{
    settings.selection = model::BrushSelection::AllInCircle;
    settings.op = model::BrushOperator::Random;
    settings.radiusPixels = kRadiusPixels;
    if (auto* create = settings.find<model::CreateSettings>()) {
        create->mix = {{1, 1.0F}, {2, 1.0F}};
        create->minimalDistance = 0.3F;
    }
    const auto inputAt = [](int dab) {
        // A quarter of the radius from dab to dab, to and fro over the lower half of the picture.
        const int column = dab % 75;
        const int row = dab / 75;
        return PointerInput::at(
            {265.0 + 10.0 * (row % 2 == 0 ? column : 74 - column), 330.0 + 80.0 * row}, dab / 60.0,
            dab / 60.0);
    };
    StrokeTimes times;
    auto start = Clock::now();
    const auto stroke = model::Stroke::begin(m_document, context(), settings, 1, inputAt(0));
    times.pressMs = since(start);
    for (int dab = 1; dab < kDabs; ++dab) {
        start = Clock::now();
        stroke->move(inputAt(dab));
        times.dabMs.push_back(since(start));
    }
    times.painted = stroke->affected();
    stroke->cancel();
    return times;
}

/// Undo of a stroke that coloured everybody.
double PaintBench::medianUndo()
{
    model::BrushSettings settings;
    settings.setKind(model::BrushKind::Colour);
    settings.selection = model::BrushSelection::Rectangle;
    settings.op = model::BrushOperator::Random;
    settings.as<model::ColourSettings>().blends = true;
    settings.through = true;
    const auto stroke =
        model::Stroke::begin(m_document, context(), settings, 2, PointerInput::at({0.0, 0.0}, 0.0));
    stroke->move(PointerInput::at({1280.0, 720.0}, 0.1));
    (void)stroke->finish();
    std::vector<double> samples;
    for (int i = 0; i < kUndos; ++i) {
        const auto start = Clock::now();
        m_document.undoStack().undo();
        samples.push_back(since(start));
        m_document.undoStack().redo();
    }
    return percentile(samples, 0.5);
}

/// The picture after a dab, on the context that there is without a window.
std::optional<double> PaintBench::medianFrame()
{
    const auto context = render::OffscreenContext::create();
    render::Renderer renderer;
    if (!context || !renderer.initialize()) {
        return std::nullopt;
    }
    std::vector<double> samples;
    for (int i = 0; i < kFrames; ++i) {
        const auto start = Clock::now();
        render::RenderInput input(fieldView(), m_keyframes);
        input.frame = m_document.frame(i / 30.0);
        input.lighting = m_document.scene().lighting;
        input.lights = m_document.scene().lights;
        if (!renderer.draw(input)) {
            renderer.destroy();
            return std::nullopt;
        }
        (void)renderer.readPixels();
        samples.push_back(since(start));
    }
    renderer.destroy();
    samples.erase(samples.begin()); // uploads everything
    return percentile(samples, 0.5);
}

AreaQueries PaintBench::queryArea(model::AreaMode mode)
{
    model::ScenePicker picker(m_keyframes, m_stage);
    const model::View view = viewFromAbove(72.0F);
    picker.update(m_document.frame(0.0), {}, view);
    std::vector<double> samples;
    for (int i = 0; i < kAreaQueries; ++i) {
        const auto start = Clock::now();
        (void)picker.individualsInArea(
            model::ScreenArea::circle(glm::dvec2(kPicture) * 0.5, kRadiusPixels * 2.0), mode);
        samples.push_back(since(start));
    }
    return {percentile(samples, 0.5), static_cast<double>(picker.candidateVisits()) / kAreaQueries};
}

/// The same people under the brush, and the others around it, all on screen.
std::vector<glm::vec3> clumpAmong(int others)
{
    std::vector<glm::vec3> places;
    places.reserve(static_cast<std::size_t>(std::max(others, kPeopleInArea)));
    for (int i = 0; i < kPeopleInArea; ++i) {
        const int row = i / 20;
        places.emplace_back(0.6F * static_cast<float>(i % 20 - 10), 0.0F,
                            0.6F * static_cast<float>(row - 10));
    }
    for (int i = kPeopleInArea; i < others; ++i) {
        const float x = 40.0F * model::unitFloat(model::hashKeys(i, 3)) + 15.0F;
        const float z = 70.0F * model::unitFloat(model::hashKeys(i, 4)) - 35.0F;
        places.emplace_back(i % 2 == 0 ? x : -x, 0.0F, z);
    }
    return places;
}

/// A dab of each other brush that changes people, as a multiple of one that colours.
void measureBrushes(PaintBench& bench, double colourMs, QJsonObject& report)
{
    for (const model::BrushKind kind : model::shownBrushes()) {
        const model::BrushType& type = model::brushType(kind);
        if (type.change == nullptr || kind == model::BrushKind::Colour) {
            continue;
        }
        model::BrushSettings settings = model::initialBrush(kind);
        if (auto* swap = settings.find<model::TemplateSettings>()) {
            swap->templates = {1, 2};
        }
        if (auto* clone = settings.find<model::CloneSettings>()) {
            clone->source = 1;
        }
        const double dabMs = percentile(bench.paint(settings).dabMs, 0.5);
        report[QLatin1String(type.info.id) + QStringLiteral("_dab_ratio")] =
            rounded(dabMs / colourMs);
    }
}

/// What queries of an area cost among 100 000 and among 10 000, the same people inside.
void measureAreas(const std::vector<model::TemplateEntry>& cast, QJsonObject& report)
{
    PaintBench few(cast, clumpAmong(10000));
    PaintBench many(cast, clumpAmong(100000));
    const auto measure = [&](model::AreaMode mode, const QString& ratio) {
        (void)many.queryArea(mode);
        const AreaQueries amongFew = few.queryArea(mode);
        const AreaQueries amongMany = many.queryArea(mode);
        report[ratio] = rounded(amongMany.medianMs / amongFew.medianMs);
        report[QStringLiteral("candidates_per_dab")] = rounded(amongMany.candidates);
        report[QStringLiteral("candidates_ratio_100k_10k")] =
            rounded(amongMany.candidates / amongFew.candidates);
    };
    measure(model::AreaMode::Visible, QStringLiteral("area_visible_ratio_100k_10k"));
    measure(model::AreaMode::Through, QStringLiteral("area_through_ratio_100k_10k"));
}

} // namespace

int runBenchPaint(const BenchPaintOptions& options)
{
    const auto cast = loadCast();
    if (!cast) {
        std::cerr << cast.error().message << '\n';
        return 1;
    }
    PaintBench bench(cast.value(), fieldOf(options.count));
    const StrokeTimes colour = bench.paint(brushOf(model::BrushKind::Colour));
    const StrokeTimes removal = bench.paint(brushOf(model::BrushKind::Delete));
    const StrokeTimes creation = bench.paint(brushOf(model::BrushKind::Create));
    const double undoMs = bench.medianUndo();
    const std::optional<double> frameMs = bench.medianFrame();
    QJsonObject report{{QStringLiteral("count"), options.count}};
    report[QStringLiteral("dab_ms_p50")] = rounded(percentile(colour.dabMs, 0.5));
    report[QStringLiteral("dab_ms_p99")] = rounded(percentile(colour.dabMs, 0.99));
    report[QStringLiteral("press_ms")] = rounded(colour.pressMs);
    report[QStringLiteral("painted")] = colour.painted;
    report[QStringLiteral("delete_dab_ms_p50")] = rounded(percentile(removal.dabMs, 0.5));
    report[QStringLiteral("create_dab_ms_p50")] = rounded(percentile(creation.dabMs, 0.5));
    report[QStringLiteral("created")] = creation.painted;
    report[QStringLiteral("undo_ms")] = rounded(undoMs);
    report[QStringLiteral("frame_ms")] = frameMs ? QJsonValue(rounded(*frameMs)) : QJsonValue();
    measureBrushes(bench, percentile(colour.dabMs, 0.5), report);
    bench.addStates(report);
    measureAreas(cast.value(), report);
    printReport(report, options.json);
    return 0;
}

} // namespace crowd::app
