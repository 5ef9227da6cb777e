// SPDX-License-Identifier: MIT
#include <set>

#include <unistd.h>

#include "app/python/BrushRules.h"
#include "app/python/ScriptSceneParts.h"

namespace crowd::app {

using namespace model;

namespace {

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

/// Whether all clips that are shown are there: where they had to be baked and `mayWait` is false,
/// they are not.
bool bakeAllShown(const Scene& scene, KeyframeStore& keyframes, bool mayWait)
{
    const auto templates = scene.population.column(columns::templateId);
    const auto clips = scene.population.column(columns::clip);
    std::set<std::pair<TemplateId, std::uint16_t>> shown;
    for (std::size_t row = 0; row < templates.size(); ++row) {
        const bool isLikeBefore =
            row > 0 && templates[row] == templates[row - 1] && clips[row] == clips[row - 1];
        if (!isLikeBefore) {
            shown.emplace(templates[row], clips[row]);
        }
    }
    bool areComplete = true;
    for (const auto& [id, clip] : shown) {
        const TemplateEntry* entry = scene.findTemplate(id);
        if (entry != nullptr && entry->asset && clip < entry->asset->clips.size()) {
            areComplete = keyframes.clip(entry->asset, clip).isComplete && areComplete;
        }
    }
    if (mayWait) {
        keyframes.waitForAll();
    }
    return areComplete || mayWait;
}

/// Graphics drivers have threads of their own, which a fork leaves behind.
bool wasForkedAfterDrawing()
{
    static std::atomic<pid_t> drawer{0};
    pid_t nobody = 0;
    drawer.compare_exchange_strong(nobody, getpid());
    return drawer != getpid();
}

} // namespace

Result<StrokeOutcome> ScriptScene::scriptStroke(const RecordedStroke& recording,
                                                const PaintWork& paint)
{
    const auto link = std::make_shared<ScriptStrokeLink>();
    const auto begun = onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        m_host.stage->setStages(m_host.document->scene().stages);
        BrushContext context{View(recording.camera, recording.viewSize), *m_host.keyframes,
                             *m_host.stage};
        context.script = link.get();
        m_stroke = Stroke::begin(*m_host.document, context, recording.settings, recording.seed,
                                 recording.inputs.front());
        for (std::size_t i = 1; i < recording.inputs.size(); ++i) {
            m_stroke->move(recording.inputs[i]);
        }
        m_stroke->settle();
        return {};
    });
    if (!begun) {
        return begun.error();
    }
    link->close();
    joinStroke(link);
    try {
        paint(*link);
    } catch (...) {
        leaveStroke();
        m_host.run([this] { m_stroke.reset(); }); // takes back what was painted
        throw;
    }
    leaveStroke();
    return onDocument([&]() -> Result<StrokeOutcome> {
        if (!m_stroke) {
            return Error{"The stroke was taken back."};
        }
        const StrokeOutcome outcome = m_stroke->finish();
        m_stroke.reset();
        return outcome;
    });
}

Result<StrokeOutcome> ScriptScene::stroke(const ScriptStroke& stroke, const PaintWork& paint)
{
    if (auto allowed = onDocument([this] { return refuseDuringEdit("A stroke"); }); !allowed) {
        return allowed.error();
    }
    const auto now = scene();
    const auto camera = cameraOrFirst(*now, stroke.camera);
    if (!camera) {
        return camera.error();
    }
    if (auto valid = checkBrush(*now, stroke.settings); !valid) {
        return valid.error();
    }
    // A stroke sees people as they are, not as they stand in until they are baked.
    if (!bakeAllShown(*now, *m_host.keyframes, m_process == getpid())) {
        return Error{
            "Characters cannot be painted on in a process that was forked from the one that "
            "has the scene: what bakes their clips is not there. Open the scene in the "
            "new process, or start that with multiprocessing's \"spawn\"."};
    }
    RecordedStroke recording;
    recording.settings = stroke.settings;
    recording.seed = stroke.seed;
    recording.camera = camera.value();
    recording.viewSize = stroke.viewSize;
    recording.inputs = stroke.inputs;
    if (stroke.settings.kind() == BrushKind::Script) {
        return scriptStroke(recording, paint);
    }
    if (stroke.settings.kind() == BrushKind::Create &&
        !stroke.settings.as<CreateSettings>().anywhere) {
        (void)m_ground.of(*now); // takes long: not while a host waits
    }
    return onDocument([&]() -> Result<StrokeOutcome> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        m_host.stage->setStages(m_host.document->scene().stages);
        return replay(*m_host.document, *m_host.keyframes, *m_host.stage, recording,
                      [this] { return m_ground.of(m_host.document->scene()); });
    });
}

/// As crowdbrush render has it: simulated up to that time where there is behaviour.
CrowdFramePtr ScriptScene::frameAt(double seconds, const Patience& patience)
{
    if (m_motion && m_motion->revision != revision()) {
        m_motion.reset();
    }
    if (!(seconds > 0.0) || !scene()->hasBehaviour()) {
        return onDocument([&] { return m_host.document->frame(seconds); });
    }
    const Snapshot now = m_motion ? Snapshot() : snapshot();
    std::atomic<bool> isCancelled{false};
    CrowdFramePtr frame;
    try {
        patience(isCancelled, [&] {
            if (!m_motion) {
                m_motion = std::make_unique<Motion>(now, isCancelled);
            }
            frame = m_motion->motion.at(seconds, &isCancelled);
        });
    } catch (...) {
        m_motion.reset(); // it stopped anywhere
        throw;
    }
    return frame;
}

Result<std::vector<std::uint8_t>> ScriptScene::picture(const ScriptPicture& picture)
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
        auto pixels = draw(picture);
        m_drawing = {};
        return pixels;
    } catch (...) {
        m_drawing = {};
        throw;
    }
}

Result<std::vector<std::uint8_t>> ScriptScene::draw(const ScriptPicture& picture)
{
    const auto now = scene();
    const auto camera = cameraOrFirst(*now, picture.camera);
    if (!camera) {
        return camera.error();
    }
    PictureRequest request;
    request.frame = picture.frame ? picture.frame : frameAt(picture.seconds, picture.patience);
    if (!m_pictures) {
        auto maker = PictureMaker::create(m_pictureKeyframes);
        if (!maker) {
            return maker.error();
        }
        m_pictures = std::move(maker).value();
    }
    const auto shown = scene(); // others may have edited it meanwhile
    const std::vector<WorldSeat> seats = shown->worldSeats();
    request.stages = shown->stages;
    request.seats = seats;
    request.seatsVersion = ++m_pictureCount;
    request.lighting = shown->lighting;
    request.camera = camera.value();
    request.size = picture.size;
    request.look = picture.look;
    const auto drawn = m_pictures->draw(request);
    std::vector<std::uint8_t> pixels = drawn ? m_pictures->pixels() : std::vector<std::uint8_t>();
    m_pictures->release(); // the next one may be wanted on another thread
    if (!drawn) {
        return drawn.error();
    }
    return pixels;
}

} // namespace crowd::app
