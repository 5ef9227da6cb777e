// SPDX-License-Identifier: MIT
#include "app/commands/RenderCommand.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "app/commands/CameraChoice.h"
#include "app/commands/InterruptGuard.h"
#include "app/commands/RenderPlan.h"
#include "app/commands/RenderProgress.h"
#include "app/commands/SceneSource.h"
#include "app/pictures/LensWish.h"
#include "app/pictures/LookWish.h"
#include "app/pictures/MovieFile.h"
#include "app/pictures/NumberedPictures.h"
#include "app/pictures/PassFile.h"
#include "app/pictures/PictureMaker.h"
#include "behavior/session/SceneMotion.h"
#include "behavior/takes/TakeFile.h"
#include "model/project/LocateAssets.h"
#include "model/rules/MarkFlaws.h"

namespace crowd::app {

namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

/// A scene with what draws it.
class ScenePictures
{
public:
    /// How it is drawn is one wish for all pictures: what it means depends on the camera.
    ScenePictures(model::Scene scene, model::CameraTrack track, const RenderPlan& plan,
                  LookWish look, const LensWish& lens)
        : m_scene(std::move(scene)), m_track(std::move(track)), m_seats(m_scene.worldSeats()),
          m_motion(m_scene), m_look(std::move(look)), m_lens(lens)
    {
        m_request.stages = m_scene.stages;
        m_request.seats = m_seats;
        m_request.lighting = m_scene.lighting;
        m_request.lights = m_scene.lights;
        m_request.size = plan.size;
        m_request.isTransparent = plan.isTransparent;
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

    /// The moment that motion in the picture of another one is said against.
    void setBefore(double before, double seconds)
    {
        m_request.earlier =
            render::EarlierMoment{frameAt(before), m_track.before(before, seconds).camera};
    }
    /// What the next picture shows.
    [[nodiscard]] model::Result<void> show(double seconds)
    {
        const auto look = lookAt(seconds);
        if (!look) {
            return look.error();
        }
        m_request.frame = frameAt(seconds);
        sayProblems();
        m_request.frame = colouredBy(look.value(), m_scene, m_request.frame);
        return {};
    }
    /// RGBA8, rows from the top; kept until the next one.
    [[nodiscard]] model::Result<std::span<const std::uint8_t>> pixels()
    {
        if (auto drawn = said(m_maker->draw(m_request)); !drawn) {
            return drawn.error();
        }
        return std::span<const std::uint8_t>(m_maker->pixels());
    }
    /// Until the program is to end.
    [[nodiscard]] model::Result<void> save(const QString& path, const PicturePasses& passes)
    {
        const auto keepGoing = [this](double share) {
            m_progress.drawn(share);
            return !InterruptGuard::isToEnd();
        };
        return said(m_maker->save(path, m_request, passes, keepGoing));
    }

private:
    /// Of a picture that was drawn, what it lacks.
    [[nodiscard]] model::Result<void> said(model::Result<void> drawn)
    {
        m_progress.end();
        if (drawn && m_keyframes.progress().isBudgetReached) {
            std::fprintf(stderr, "The memory for keyframes is used up: some clips stand still.\n");
        }
        if (drawn && m_maker->isReduced()) {
            std::fprintf(stderr, "The memory of the graphics card is used up: characters and "
                                 "pictures are coarser.\n");
        }
        return drawn;
    }
    /// What the camera sees then, and how.
    [[nodiscard]] model::Result<ChosenLook> lookAt(double seconds)
    {
        const model::DirectedCamera now = m_track.at(seconds);
        m_request.camera = now.camera;
        const auto lens = lensOf(m_lens, now.camera);
        if (!lens) {
            return lens.error();
        }
        m_request.lens = lens.value();
        m_look.directed = now.look;
        auto look = chosenLook(m_look, m_scene);
        if (look) {
            m_request.look = look.value().look;
            m_request.ownLook = look.value().own;
        }
        return look;
    }
    [[nodiscard]] model::CrowdFramePtr frameAt(double seconds)
    {
        auto frame = m_motion.at(seconds, nullptr, [this, seconds](double done) {
            m_progress.simulated(done, seconds);
        });
        m_progress.end();
        return frame;
    }
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
    model::CameraTrack m_track;
    std::vector<model::WorldSeat> m_seats;
    behavior::SceneMotion m_motion;
    model::KeyframeStore m_keyframes{std::size_t{2} << 30U};
    PictureRequest m_request;
    LookWish m_look;
    LensWish m_lens;
    std::set<std::string> m_said;
    RenderProgress m_progress;
    std::unique_ptr<PictureMaker> m_maker;
};

/// Says why the timeline's camera does not do what marks say.
void sayFlaws(const model::Scene& scene)
{
    const auto flaws = model::flawsOfMarks(scene);
    for (const model::Mark& mark : model::inOrder(scene.timeline)) {
        const auto flaw = flaws.find(mark.id);
        if (mark.kind == model::MarkKind::Camera && flaw != flaws.end()) {
            std::fprintf(stderr, "%s\n", flaw->second.english().c_str());
        }
    }
}

int fail(const model::Error& error, int code = kFailed)
{
    std::fprintf(stderr, "crowdbrush render: %s\n", error.message.c_str());
    return code;
}

/// Says what pictures would lack; an error unless that is allowed.
model::Result<void> checkMissing(const model::Scene& scene, bool isAllowed)
{
    const std::vector<std::string> missing = model::missingFromPictures(scene);
    for (const std::string& each : missing) {
        std::fprintf(stderr, "Missing: %s\n", each.c_str());
    }
    if (missing.empty() || isAllowed) {
        return {};
    }
    return model::Error{
        "Nothing was drawn: the pictures would lack what is missing. Open the scene "
        "in the editor and locate it, or draw without it by --allow-missing."};
}

/// Each frame in a file of its own.
model::Result<void> writeFrames(ScenePictures& pictures, const RenderPlan& plan,
                                const std::string& pattern)
{
    std::optional<int> next = plan.frames.first();
    for (; next; next = plan.frames.after(*next)) {
        const int frame = *next;
        const QString path = fileForFrame(QString::fromStdString(pattern), frame);
        if (plan.isResumed && arePassesThere(path, plan.passes, plan.size)) {
            continue;
        }
        if (needAny(plan.passes, PassNeed::Motion)) {
            pictures.setBefore(plan.secondsBefore(frame), plan.secondsOf(frame));
        }
        if (auto shown = pictures.show(plan.secondsOf(frame)); !shown) {
            return shown;
        }
        {
            const InterruptGuard guard;
            if (auto written = pictures.save(path, plan.passes); !written) {
                return written;
            }
        }
        for (const QString& file : passFiles(path, plan.passes)) {
            std::printf("%s\n", qPrintable(file));
        }
        std::fflush(stdout); // who reads along knows that the file is there
    }
    return {};
}

/// All in one; Ctrl+C leaves nothing of it.
model::Result<void> writeMovie(ScenePictures& pictures, const RenderPlan& plan,
                               const std::string& output)
{
    const InterruptGuard guard;
    const QString path = QString::fromStdString(output);
    auto movie = MovieFile::create(path, plan.size, plan.framesPerSecond);
    if (!movie) {
        return movie.error();
    }
    std::optional<int> next = plan.frames.first();
    for (; next; next = plan.frames.after(*next)) {
        const int frame = *next;
        if (InterruptGuard::isToEnd()) {
            return {};
        }
        if (auto shown = pictures.show(plan.secondsOf(frame)); !shown) {
            return shown;
        }
        const auto pixels = pictures.pixels();
        if (!pixels) {
            return pixels.error();
        }
        if (auto added = movie.value()->add(pixels.value()); !added) {
            return added;
        }
    }
    if (auto finished = movie.value()->finish(); !finished) {
        return finished;
    }
    std::printf("%s\n", qPrintable(path));
    return {};
}

model::Result<void> readable(const model::Take& take)
{
    if (!take.motion) {
        return model::Error{take.problem};
    }
    if (const auto opened = behavior::openTake(take.motion); !opened) {
        return opened.error();
    }
    return {};
}

/// Empty: the one that the scene shows, if any.
model::Result<void> chooseTake(model::Scene& scene, const std::string& name)
{
    const model::Take* shown = model::shownTake(scene.takes);
    if (name.empty()) {
        const auto opened = shown != nullptr ? readable(*shown) : model::Result<void>();
        return opened ? opened
                      : model::Error{opened.error().message +
                                     " --take none draws the scene as it plays."};
    }
    std::string names;
    bool isThere = name == "none";
    for (model::Take& take : scene.takes) {
        take.isShown = !isThere && take.name == name;
        isThere = isThere || take.isShown;
        names += (names.empty() ? "" : ", ") + take.name;
        if (take.isShown) {
            if (auto opened = readable(take); !opened) {
                return opened;
            }
        }
    }
    if (!isThere) {
        return model::Error{"There is no take named \"" + name + "\". " +
                            (names.empty() ? "The scene has none; leave --take away."
                                           : "The scene has: " + names + ".")};
    }
    return {};
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
    if (auto shown = chooseTake(scene.value(), options.take); !shown) {
        return fail(shown.error(), kBadUsage);
    }
    auto track = chosenCamera(
        {options.camera, options.cameraMove, plan.value().beginSeconds(), plan.value().seconds()},
        scene.value());
    if (!track) {
        return fail(track.error());
    }
    const model::DirectedCamera begin = track.value().at(plan.value().beginSeconds());
    if (const auto lens = lensOf({options.focusMetres, options.fStop}, begin.camera); !lens) {
        return fail(lens.error(), kBadUsage);
    }
    const LookWish wish{options.look, options.by, std::nullopt, begin.look};
    if (const auto look = chosenLook(wish, scene.value()); !look) {
        return fail(look.error(), kBadUsage);
    }
    if (options.camera.empty() && options.cameraMove.empty()) {
        sayFlaws(scene.value());
    }
    if (auto complete = checkMissing(scene.value(), options.allowsMissing); !complete) {
        return fail(complete.error());
    }
    InterruptGuard::install();
    ScenePictures pictures(std::move(scene).value(), std::move(track).value(), plan.value(),
                           {options.look, options.by}, {options.focusMetres, options.fStop});
    if (auto opened = pictures.open(); !opened) {
        return fail(opened.error());
    }
    const auto write = plan.value().isMovie ? &writeMovie : &writeFrames;
    if (auto written = write(pictures, plan.value(), options.output); !written) {
        return fail(written.error());
    }
    return 0;
}

} // namespace crowd::app
