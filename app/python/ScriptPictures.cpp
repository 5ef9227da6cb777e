// SPDX-License-Identifier: MIT
#include "app/python/ScriptPictures.h"

#include <atomic>

#include <unistd.h>

#include "app/python/ScriptScene.h"
#include "behavior/session/SceneMotion.h"

namespace crowd::app {

using namespace model;

namespace {

/// Graphics drivers have threads of their own, which a fork leaves behind.
bool wasForkedAfterDrawing()
{
    static std::atomic<pid_t> drawer{0};
    pid_t nobody = 0;
    drawer.compare_exchange_strong(nobody, getpid());
    return drawer != getpid();
}

Result<ScriptDrawing> drawWith(PictureMaker& maker, const PictureRequest& request,
                               const ScriptPicture& picture)
{
    if (auto drawn = maker.draw(request, picture.keepGoing); !drawn) {
        return drawn.error();
    }
    auto layers = maker.layers(request, picture.passes, picture.keepGoing);
    if (!layers) {
        return layers.error();
    }
    return ScriptDrawing{maker.pixels(), std::move(layers).value(),
                         exrHeaderOf(picture.passes, request.camera, request.size, *request.frame)};
}

} // namespace

/// What moves in pictures of a later time.
struct ScriptPictures::Motion
{
    Motion(const ScriptScene::Snapshot& now, const std::atomic<bool>& isCancelled)
        : scene(now.scene), revision(now.revision), motion(*scene, &isCancelled)
    {
    }

    std::shared_ptr<const Scene> scene;
    std::uint64_t revision;
    behavior::SceneMotion motion;
};

ScriptPictures::ScriptPictures() : m_keyframes(kScriptKeyframeBytes) {}

ScriptPictures::~ScriptPictures() = default;

Result<Camera> cameraOrFirst(const Scene& scene, const std::optional<Camera>& camera)
{
    if (camera) {
        return *camera;
    }
    if (scene.cameras.empty()) {
        return Error{"The scene has no camera: give one, as in "
                     "camera=crowdbrush.Camera((0, 5, 10), (0, 0, 0))."};
    }
    return scene.cameras.front().camera;
}

/// As crowdbrush render has it: as in the take that is shown, else simulated up to that time where
/// there is behaviour.
CrowdFramePtr ScriptPictures::frameAt(ScriptScene& script, double seconds, const Patience& patience)
{
    if (m_motion && m_motion->revision != script.revision()) {
        m_motion.reset();
    }
    const std::shared_ptr<const Scene> scene = script.scene();
    const bool isPlayed = seconds > 0.0 && scene->hasBehaviour();
    if (!isPlayed && shownTake(scene->takes) == nullptr) {
        return script.onDocument([&] { return script.document().frame(seconds); });
    }
    const ScriptScene::Snapshot now = m_motion ? ScriptScene::Snapshot() : script.snapshot();
    Waiting waiting;
    CrowdFramePtr frame;
    try {
        patience(waiting, [&] {
            if (!m_motion) {
                m_motion = std::make_unique<Motion>(now, waiting.isCancelled);
            }
            frame = m_motion->motion.at(seconds, &waiting.isCancelled, [&](double simulated) {
                waiting.share = simulated / seconds;
            });
        });
    } catch (...) {
        m_motion.reset(); // it stopped anywhere
        throw;
    }
    return frame;
}

Result<ScriptDrawing> ScriptPictures::picture(ScriptScene& script, const ScriptPicture& picture)
{
    if (wasForkedAfterDrawing()) {
        return Error{"Pictures cannot be drawn in a process that was forked from one that draws: "
                     "the graphics driver's threads are not there. Start another process instead, "
                     "with subprocess or multiprocessing's \"spawn\"."};
    }
    if (m_drawing != std::thread::id()) {
        return Error{"Another picture of this scene is being drawn."};
    }
    m_drawing = std::this_thread::get_id();
    try {
        auto pixels = draw(script, picture);
        m_drawing = {};
        return pixels;
    } catch (...) {
        m_drawing = {};
        throw;
    }
}

Result<ScriptDrawing> ScriptPictures::draw(ScriptScene& script, const ScriptPicture& picture)
{
    const auto now = script.scene();
    const auto camera = cameraOrFirst(*now, picture.camera);
    if (!camera) {
        return camera.error();
    }
    const auto lens = lensOf(picture.lens, camera.value());
    if (!lens) {
        return lens.error();
    }
    PictureRequest request;
    request.lens = lens.value();
    if (picture.before) { // first: times that rise are quick
        const auto frame = picture.frameBefore
                               ? picture.frameBefore
                               : frameAt(script, picture.before->seconds, picture.patience);
        request.earlier = render::EarlierMoment{frame, picture.before->camera};
    }
    request.frame =
        picture.frame ? picture.frame : frameAt(script, picture.seconds, picture.patience);
    if (!m_maker) {
        auto maker = PictureMaker::create(m_keyframes);
        if (!maker) {
            return maker.error();
        }
        m_maker = std::move(maker).value();
    }
    const auto shown = script.scene(); // others may have edited it meanwhile
    const std::vector<WorldSeat> seats = shown->worldSeats();
    request.stages = shown->stages;
    request.seats = seats;
    request.seatsVersion = ++m_count;
    request.lighting = shown->lighting;
    request.lights = shown->lights;
    request.camera = camera.value();
    request.size = picture.size;
    request.isTransparent = picture.isTransparent;
    request.look = picture.look.look;
    request.ownLook = picture.look.own;
    request.frame = colouredBy(picture.look, *shown, request.frame);
    auto drawn = drawWith(*m_maker, request, picture);
    m_maker->release(); // the next one may be wanted on another thread
    return drawn;
}

} // namespace crowd::app
