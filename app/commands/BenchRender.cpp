// SPDX-License-Identifier: MIT
#include "app/commands/BenchRender.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

#include <epoxy/gl.h>

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "app/commands/BenchScene.h"
#include "app/commands/OptionText.h"
#include "app/commands/PictureQuality.h"
#include "app/commands/SceneSource.h"
#include "app/pictures/PictureFile.h"
#include "model/bake/ClipBaker.h"
#include "model/project/LocateAssets.h"
#include "model/scene/ReadyLight.h"
#include "render/OffscreenContext.h"
#include "render/Renderer.h"
#include "render/reference/PaperMethod.h"
#include "render/reference/SyntheticPerson.h"

namespace crowd::app {

namespace {

using Clock = std::chrono::steady_clock;
using render::OffscreenContext;

constexpr int kWarmUpFrames = 5;
constexpr double kFrameSeconds = 1.0 / 30.0;

struct Timing
{
    double median = 0.0;
    double p95 = 0.0;
};

Timing timingOf(std::vector<double> samples)
{
    std::ranges::sort(samples);
    return {samples[samples.size() / 2], samples[samples.size() * 95 / 100]};
}

/// Milliseconds from an arbitrary origin: of the wall clock, or of processor time in all threads.
double now(bool isProcessorTime)
{
    if (isProcessorTime) {
        timespec spent{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
        return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
    }
    return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

model::Result<model::Scene> loadWorkload(const BenchRenderOptions& options)
{
    if (!options.scene.empty()) {
        auto scene = loadForPicture(QString::fromStdString(options.scene));
        if (scene) {
            const auto missing = model::missingFromPictures(scene.value());
            if (!missing.empty()) {
                return model::Error{options.scene + " is not complete: " + missing.front() +
                                    " Open it in the editor and locate what is missing."};
            }
            seatMore(scene.value(), static_cast<std::size_t>(options.count));
            keepPeople(scene.value(), static_cast<std::size_t>(options.count));
        }
        return scene;
    }
    if (options.triangles > 0) {
        return makeBenchField({render::makeSyntheticPerson(options.triangles)}, options.count,
                              options.field == "far");
    }
    std::vector<model::TemplatePtr> assets;
    for (const char* name : {"builtin:templates/man.glb", "builtin:templates/woman.glb"}) {
        auto asset = loadBuiltinTemplate(name);
        if (!asset) {
            return asset.error();
        }
        assets.push_back(asset.value());
    }
    return makeBenchField(assets, options.count, options.field == "far");
}

/// Both ways of drawing with what they draw.
class Comparison
{
public:
    Comparison(const BenchRenderOptions& options, glm::ivec2 size, model::Scene scene)
        : m_options(options), m_size(size), m_scene(std::move(scene)),
          m_seats(m_scene.worldSeats()),
          m_templates(std::make_shared<const std::vector<model::TemplateEntry>>(m_scene.templates))
    {
    }
    ~Comparison();

    [[nodiscard]] model::Result<void> open();
    [[nodiscard]] model::Result<void> run();
    [[nodiscard]] model::Result<void> writePictures() const;
    /// What is lost by levels, at some other times.
    [[nodiscard]] model::Result<void> measureLoss();
    [[nodiscard]] bool losesTooMuch() const;
    [[nodiscard]] QJsonObject report() const;

private:
    [[nodiscard]] render::RenderInput inputAt(double seconds);
    [[nodiscard]] model::Result<double> timeOurs(double seconds, render::Look look,
                                                 bool smoothsEdges);
    [[nodiscard]] model::Result<void> timePlain(double seconds, bool isWarm);
    [[nodiscard]] model::Result<double> timeReference(double seconds);
    [[nodiscard]] model::Result<std::vector<std::uint8_t>> picture(double seconds, bool isFull,
                                                                   int scale);

    const BenchRenderOptions& m_options;
    glm::ivec2 m_size;
    model::Scene m_scene;
    std::vector<model::WorldSeat> m_seats;
    std::shared_ptr<const std::vector<model::TemplateEntry>> m_templates;
    model::KeyframeStore m_keyframes;
    std::unique_ptr<OffscreenContext> m_core;
    std::unique_ptr<OffscreenContext> m_compatibility;
    render::Renderer m_renderer;
    render::PaperMethod m_paper;
    std::vector<double> m_ours;
    std::vector<double> m_reference;
    std::vector<double> m_plain; ///< ours without light, where a look is asked for
    std::vector<double> m_plan;  ///< of ours: phase, cull, level, sort
    std::vector<double> m_cpu;   ///< the same and static records
    PictureQuality m_full;       ///< the means of what was measured
    PictureQuality m_levels;
};

Comparison::~Comparison()
{
    if (m_compatibility && m_compatibility->makeCurrent()) {
        m_paper.destroy();
    }
    if (m_core && m_core->makeCurrent()) {
        m_renderer.destroy();
    }
}

model::Result<void> Comparison::open()
{
    auto compatibility = OffscreenContext::create(OffscreenContext::Profile::Compatibility);
    if (!compatibility) {
        return compatibility.error();
    }
    m_compatibility = std::move(compatibility).value();
    auto core = OffscreenContext::create();
    if (!core) {
        return core.error();
    }
    m_core = std::move(core).value();
    return m_renderer.initialize();
}

render::RenderInput Comparison::inputAt(double seconds)
{
    const model::Camera camera =
        m_scene.cameras.empty() ? model::Camera{} : m_scene.cameras.front().camera;
    render::RenderInput input(model::View(camera, glm::vec2(m_size)), m_keyframes);
    auto frame = std::make_shared<model::CrowdFrame>();
    frame->population = m_scene.population;
    frame->templates = m_templates;
    frame->seconds = seconds;
    input.frame = frame;
    input.stages = m_scene.stages;
    input.seats = m_seats;
    input.seatsVersion = 1;
    input.lighting = m_scene.lighting;
    input.lights = m_scene.lights;
    input.samples = m_options.samples;
    const float usual = m_options.samples > 0 ? 6.0F : 18.0F; // as in the window
    input.levels.impostorPixels = m_options.impostors >= 0.0F ? m_options.impostors : usual;
    if (m_options.detail == "full") {
        input.levels = render::LevelThresholds::fullDetail();
    } else if (!m_options.thresholds.empty()) {
        std::ranges::copy(m_options.thresholds, input.levels.pixels.begin());
    }
    return input;
}

/// `scale`: times as wide and high.
model::Result<std::vector<std::uint8_t>> Comparison::picture(double seconds, bool isFull, int scale)
{
    (void)m_core->makeCurrent();
    render::RenderInput input = inputAt(seconds);
    input.pixelSize = m_size * scale;
    input.smoothsEdges = m_options.edges;
    input.levels.hysteresis = 0.0F;
    if (isFull) {
        input.levels = render::LevelThresholds::fullDetail();
    }
    auto drawn = m_renderer.draw(input);
    m_keyframes.waitForAll(); // of times that were not timed
    drawn = drawn ? m_renderer.draw(input) : drawn;
    if (!drawn) {
        return drawn.error();
    }
    return m_renderer.readPixels();
}

model::Result<void> Comparison::measureLoss()
{
    constexpr int kMoments = 4;
    constexpr double kApart = 1.37; // seconds: at no moment is everybody as at another
    const auto add = [](PictureQuality& sum, const PictureQuality& each) {
        sum.psnr += each.psnr / kMoments;
        sum.ssim += each.ssim / kMoments;
    };
    for (int i = 0; i < kMoments; ++i) {
        const double seconds = kApart * i;
        const auto large = picture(seconds, true, 2);
        const auto full = picture(seconds, true, 1);
        const auto levels = picture(seconds, false, 1);
        for (const auto* each : {&large, &full, &levels}) {
            if (!*each) {
                return each->error();
            }
        }
        const std::vector<std::uint8_t> truth = halved(large.value(), m_size * 2);
        add(m_full, qualityOf(full.value(), truth, m_size));
        add(m_levels, qualityOf(levels.value(), truth, m_size));
    }
    return {};
}

bool Comparison::losesTooMuch() const
{
    return m_full.psnr - m_levels.psnr > kMostLostPsnr ||
           m_full.ssim - m_levels.ssim > kMostLostSsim;
}

model::Result<double> Comparison::timeOurs(double seconds, render::Look look, bool smoothsEdges)
{
    (void)m_core->makeCurrent();
    render::RenderInput input = inputAt(seconds);
    input.look = look;
    input.smoothsEdges = smoothsEdges;
    const double start = now(m_options.clock == "cpu");
    if (auto drawn = m_renderer.draw(input); !drawn) {
        return drawn.error();
    }
    glFinish();
    return now(m_options.clock == "cpu") - start;
}

model::Result<double> Comparison::timeReference(double seconds)
{
    (void)m_compatibility->makeCurrent();
    const render::RenderInput input = inputAt(seconds);
    const double start = now(m_options.clock == "cpu");
    if (auto drawn = m_paper.draw(input); !drawn) {
        return drawn.error();
    }
    glFinish();
    return now(m_options.clock == "cpu") - start;
}

model::Result<void> Comparison::timePlain(double seconds, bool isWarm)
{
    auto plain = timeOurs(seconds, render::Look::Plain, false);
    if (!plain) {
        return plain.error();
    }
    if (isWarm) {
        m_plain.push_back(plain.value());
    }
    return {};
}

model::Result<void> Comparison::run()
{
    const auto look = render::lookOfKey(m_options.look).value_or(render::Look::Lit);
    for (int i = 0; i < kWarmUpFrames + m_options.frames; ++i) {
        const double seconds = i * kFrameSeconds;
        if (auto plain = timePlain(seconds, i >= kWarmUpFrames); !plain) {
            return plain.error();
        }
        auto ours = timeOurs(seconds, look, m_options.edges); // last: whose picture is written
        if (!ours) {
            return ours.error();
        }
        m_keyframes.waitForAll();
        auto reference = timeReference(seconds);
        if (!reference) {
            return reference.error();
        }
        if (i >= kWarmUpFrames) {
            m_ours.push_back(ours.value());
            m_reference.push_back(reference.value());
            const render::RenderStatistics& drawn = m_renderer.statistics();
            m_plan.push_back(drawn.planMs);
            m_cpu.push_back(drawn.recordsMs + drawn.planMs);
        }
    }
    return {};
}

model::Result<void> Comparison::writePictures() const
{
    const QString name = QString::fromStdString(m_options.picture);
    (void)m_core->makeCurrent();
    if (auto written =
            writePicture(name + QStringLiteral("-ours.png"), m_renderer.readPixels(), m_size);
        !written) {
        return written;
    }
    (void)m_compatibility->makeCurrent();
    return writePicture(name + QStringLiteral("-reference.png"), m_paper.readPixels(), m_size);
}

QJsonObject Comparison::report() const
{
    const Timing ours = timingOf(m_ours);
    const Timing reference = timingOf(m_reference);
    const render::RenderStatistics& drawn = m_renderer.statistics();
    const model::Template* asset = nullptr;
    for (const model::TemplateEntry& entry : m_scene.templates) {
        asset = asset == nullptr && entry.asset ? entry.asset.get() : asset;
    }
    const model::Mesh* mesh = asset != nullptr ? &asset->levels.front() : nullptr;
    QJsonObject json;
    json[QStringLiteral("field")] = QString::fromStdString(m_options.field);
    json[QStringLiteral("count")] = static_cast<qint64>(m_scene.population.size());
    json[QStringLiteral("triangles")] =
        static_cast<qint64>(mesh != nullptr ? mesh->triangleCount() : 0);
    json[QStringLiteral("width")] = m_size.x;
    json[QStringLiteral("height")] = m_size.y;
    json[QStringLiteral("detail")] = QString::fromStdString(m_options.detail);
    json[QStringLiteral("samples")] = m_options.samples;
    json[QStringLiteral("edges")] = m_options.edges;
    json[QStringLiteral("clock")] = QString::fromStdString(m_options.clock);
    json[QStringLiteral("median_ms")] = ours.median;
    json[QStringLiteral("p95_ms")] = ours.p95;
    json[QStringLiteral("draws")] = drawn.draws;
    QJsonArray levels;
    for (const int people : drawn.byLevel) {
        levels.append(people);
    }
    json[QStringLiteral("people_by_level")] = levels;
    json[QStringLiteral("triangles_drawn")] = static_cast<qint64>(drawn.triangles);
    json[QStringLiteral("bytes_per_keyframe")] = static_cast<qint64>(
        mesh != nullptr ? mesh->positions.size() * sizeof(model::PackedVertex) : 0);
    json[QStringLiteral("look")] = QString::fromStdString(m_options.look);
    json[QStringLiteral("plain_ms")] = timingOf(m_plain).median;
    json[QStringLiteral("to_plain")] = ours.median / timingOf(m_plain).median;
    json[QStringLiteral("plan_ms")] = timingOf(m_plan).median;
    json[QStringLiteral("cpu_ms")] = timingOf(m_cpu).median;
    json[QStringLiteral("reference")] =
        QJsonObject{{QStringLiteral("method"), QStringLiteral("display list per keyframe and "
                                                              "material, fixed-function light")},
                    {QStringLiteral("median_ms"), reference.median}};
    json[QStringLiteral("ratio")] = reference.median / ours.median;
    if (m_options.quality) {
        json[QStringLiteral("full_psnr")] = m_full.psnr;
        json[QStringLiteral("full_ssim")] = m_full.ssim;
        json[QStringLiteral("lost_psnr")] = m_full.psnr - m_levels.psnr;
        json[QStringLiteral("lost_ssim")] = m_full.ssim - m_levels.ssim;
    }
    return json;
}

int failBench(const model::Error& error)
{
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return 1;
}

void printComparison(const QJsonObject& report, bool isJson)
{
    if (isJson) {
        std::printf("%s\n", QJsonDocument(report).toJson(QJsonDocument::Compact).constData());
        return;
    }
    const QJsonObject reference = report[QStringLiteral("reference")].toObject();
    std::printf(
        "%d characters of %d triangles, %d by %d pixels, detail %s\n"
        "ours       %8.2f ms median, %.2f ms at the 95th percentile, %d draws, %.0f "
        "triangles\nreference  %8.2f ms median (%s)\nratio      %8.2f\n"
        "plain      %8.2f ms median; look %s takes %.2f of it\n",
        report[QStringLiteral("count")].toInt(), report[QStringLiteral("triangles")].toInt(),
        report[QStringLiteral("width")].toInt(), report[QStringLiteral("height")].toInt(),
        qPrintable(report[QStringLiteral("detail")].toString()),
        report[QStringLiteral("median_ms")].toDouble(), report[QStringLiteral("p95_ms")].toDouble(),
        report[QStringLiteral("draws")].toInt(),
        report[QStringLiteral("triangles_drawn")].toDouble(),
        reference[QStringLiteral("median_ms")].toDouble(),
        qPrintable(reference[QStringLiteral("method")].toString()),
        report[QStringLiteral("ratio")].toDouble(), report[QStringLiteral("plain_ms")].toDouble(),
        qPrintable(report[QStringLiteral("look")].toString()),
        report[QStringLiteral("to_plain")].toDouble());
    if (report.contains(QStringLiteral("lost_psnr"))) {
        std::printf("lost       %8.2f dB of %.2f, %.4f of similarity %.4f\n",
                    report[QStringLiteral("lost_psnr")].toDouble(),
                    report[QStringLiteral("full_psnr")].toDouble(),
                    report[QStringLiteral("lost_ssim")].toDouble(),
                    report[QStringLiteral("full_ssim")].toDouble());
    }
}

} // namespace

int runBenchRender(const BenchRenderOptions& options)
{
    const auto size = parseSize(options.size);
    if (!size) {
        std::fprintf(stderr, "--size %s is not a size in pixels: give it as WIDTHxHEIGHT.\n",
                     options.size.c_str());
        return 2;
    }
    auto scene = loadWorkload(options);
    if (!scene) {
        return failBench(scene.error());
    }
    if (!options.light.empty()) {
        const model::ReadyLight* ready = model::findReadyLight(options.light);
        if (ready == nullptr) {
            return failBench({"There is no ready-made light " + options.light + "."});
        }
        scene.value().lighting = model::litAs(*ready, scene.value().lighting);
    }
    Comparison comparison(options, *size, std::move(scene).value());
    if (auto opened = comparison.open(); !opened) {
        return failBench(opened.error());
    }
    if (auto ran = comparison.run(); !ran) {
        return failBench(ran.error());
    }
    if (!options.picture.empty()) {
        if (auto written = comparison.writePictures(); !written) {
            return failBench(written.error());
        }
    }
    if (options.quality) {
        if (auto measured = comparison.measureLoss(); !measured) {
            return failBench(measured.error());
        }
    }
    printComparison(comparison.report(), options.json);
    if (options.quality && comparison.losesTooMuch()) {
        return failBench({"More is lost by levels than may be: at most 0.6 dB and 0.010 of "
                          "structural similarity. Raise no threshold so far."});
    }
    return 0;
}

} // namespace crowd::app
