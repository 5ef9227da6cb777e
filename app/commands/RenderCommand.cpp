// SPDX-License-Identifier: MIT
#include "app/commands/RenderCommand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include <QtCore/QString>
#include <QtCore/QStringList>

#include "app/commands/OptionText.h"
#include "app/commands/SceneSource.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureMaker.h"
#include "behavior/session/SceneMotion.h"

namespace crowd::app {

namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

/// Options as understood.
struct Plan
{
    glm::ivec2 size{1280, 720};
    render::Look look = render::Look::Lit;
    int firstFrame = 0;
    int lastFrame = 0;
    bool isSequence = false;
};

std::optional<render::Look> lookNamed(const std::string& name)
{
    for (int i = 0; i < static_cast<int>(render::Look::Count); ++i) {
        const auto look = static_cast<render::Look>(i);
        if (name == render::lookName(look)) {
            return look;
        }
    }
    return std::nullopt;
}

std::string knownLooks()
{
    std::string names;
    for (int i = 0; i < static_cast<int>(render::Look::Count); ++i) {
        names += (i > 0 ? ", " : "") + std::string(render::lookName(static_cast<render::Look>(i)));
    }
    return names;
}

model::Result<void> planFrames(const RenderOptions& options, Plan& plan)
{
    const bool hasPlace = options.output.find('#') != std::string::npos;
    if (options.frames.empty()) {
        if (hasPlace) {
            return model::Error{"--output " + options.output +
                                " has a place for frame numbers: say which with --frames A-B."};
        }
        return {};
    }
    const auto range = parsePair(options.frames, '-');
    if (!range || range->x < 0 || range->y < range->x) {
        return model::Error{"--frames " + options.frames +
                            " is not a range of frames: give it as A-B, such as 0-99."};
    }
    if (!hasPlace && range->x != range->y) {
        return model::Error{"--output " + options.output +
                            " would be written over and over: put #### where the frame number "
                            "goes, such as f_####.png."};
    }
    if (!(options.framesPerSecond > 0.0)) {
        return model::Error{"--fps must be above zero."};
    }
    plan.isSequence = true;
    plan.firstFrame = range->x;
    plan.lastFrame = range->y;
    return {};
}

model::Result<Plan> planOf(const RenderOptions& options)
{
    Plan plan;
    const auto size = parseSize(options.size);
    if (!size) {
        return model::Error{"--size " + options.size +
                            " is not a size in pixels: give it as WIDTHxHEIGHT, such as 1280x720, "
                            "at most 16384 a side."};
    }
    plan.size = *size;
    const auto look = lookNamed(options.look);
    if (!look) {
        return model::Error{"--look " + options.look + " is unknown; there are: " + knownLooks() +
                            "."};
    }
    plan.look = *look;
    if (!std::isfinite(options.time)) {
        return model::Error{"--time must be a number of seconds."};
    }
    if (auto frames = planFrames(options, plan); !frames) {
        return frames.error();
    }
    return plan;
}

model::Result<model::Camera> cameraNamed(const model::Scene& scene, const std::string& name)
{
    if (name.empty()) {
        return scene.cameras.empty() ? model::Camera{} : scene.cameras.front().camera;
    }
    const auto found = std::ranges::find(scene.cameras, name, &model::NamedCamera::name);
    if (found != scene.cameras.end()) {
        return found->camera;
    }
    std::string names;
    for (const model::NamedCamera& camera : scene.cameras) {
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    return model::Error{"There is no camera named \"" + name + "\". " +
                        (names.empty() ? "The scene has none; leave --camera away."
                                       : "The scene has: " + names + ".")};
}

/// f_####.png → f_0007.png; a name without # stays.
QString fileForFrame(const std::string& pattern, int frame)
{
    QString name = QString::fromStdString(pattern);
    const auto first = name.indexOf(QLatin1Char('#'));
    if (first < 0) {
        return name;
    }
    auto end = first;
    while (end < name.size() && name[end] == QLatin1Char('#')) {
        ++end;
    }
    return name.replace(
        first, end - first,
        QStringLiteral("%1").arg(frame, static_cast<int>(end - first), 10, QLatin1Char('0')));
}

/// A scene with what draws it.
class ScenePictures
{
public:
    ScenePictures(model::Scene scene, const model::Camera& camera, const Plan& plan)
        : m_scene(std::move(scene)), m_seats(m_scene.worldSeats()), m_motion(m_scene)
    {
        m_request.stages = m_scene.stages;
        m_request.seats = m_seats;
        m_request.lighting = m_scene.lighting;
        m_request.camera = camera;
        m_request.size = plan.size;
        m_request.look = plan.look;
    }
    ScenePictures(const ScenePictures&) = delete;
    ScenePictures& operator=(const ScenePictures&) = delete;

    [[nodiscard]] model::Result<void> open()
    {
        auto maker = PictureMaker::create(m_keyframes);
        if (!maker) {
            return maker.error();
        }
        m_maker = std::move(maker).value();
        sayProblems();
        return {};
    }

    [[nodiscard]] model::Result<void> write(double seconds, const QString& path)
    {
        m_request.frame = m_motion.at(seconds);
        sayProblems();
        if (auto drawn = m_maker->draw(m_request); !drawn) {
            return drawn;
        }
        if (m_keyframes.progress().isBudgetReached) {
            std::fprintf(stderr, "The memory for keyframes is used up: some clips stand still.\n");
        }
        return writePicture(path, m_maker->pixels(), m_maker->size());
    }

private:
    /// Each sentence once, as soon as there is reason to.
    void sayProblems()
    {
        for (const std::string& problem : m_motion.problems()) {
            if (m_said.insert(problem).second) {
                std::fprintf(stderr, "%s\n", problem.c_str());
            }
        }
    }

    model::Scene m_scene;
    std::vector<model::WorldSeat> m_seats;
    behavior::SceneMotion m_motion;
    model::KeyframeStore m_keyframes{std::size_t{2} << 30U};
    PictureRequest m_request;
    std::set<std::string> m_said;
    std::unique_ptr<PictureMaker> m_maker;
};

int fail(const model::Error& error, int code = kFailed)
{
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return code;
}

/// What is missing is said, and the rest drawn.
void warnOfMissing(const model::Scene& scene)
{
    for (const model::TemplateEntry& entry : scene.templates) {
        if (!entry.asset) {
            std::fprintf(stderr, "Not drawn: template %s. %s\n", entry.name.c_str(),
                         entry.problem.c_str());
        }
    }
    for (const model::StageEntry& entry : scene.stages) {
        if (!entry.asset) {
            std::fprintf(stderr, "Not drawn: stage %s. %s\n", entry.name.c_str(),
                         entry.problem.c_str());
        }
    }
}

} // namespace

int runRender(const RenderOptions& options)
{
    const auto plan = planOf(options);
    if (!plan) {
        return fail(plan.error(), kBadUsage);
    }
    auto scene = loadForPicture(QString::fromStdString(options.scene));
    if (!scene) {
        return fail(scene.error());
    }
    const auto camera = cameraNamed(scene.value(), options.camera);
    if (!camera) {
        return fail(camera.error());
    }
    warnOfMissing(scene.value());
    ScenePictures pictures(std::move(scene).value(), camera.value(), plan.value());
    if (auto opened = pictures.open(); !opened) {
        return fail(opened.error());
    }
    for (int frame = plan.value().firstFrame; frame <= plan.value().lastFrame; ++frame) {
        const double seconds =
            options.time +
            (plan.value().isSequence ? static_cast<double>(frame) / options.framesPerSecond : 0.0);
        const QString path = fileForFrame(options.output, frame);
        if (auto written = pictures.write(seconds, path); !written) {
            return fail(written.error());
        }
        std::printf("%s\n", qPrintable(path));
    }
    return 0;
}

} // namespace crowd::app
