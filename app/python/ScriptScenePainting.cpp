// SPDX-License-Identifier: MIT
#include <set>

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

void bakeAllShown(const Scene& scene, KeyframeStore& keyframes)
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
    for (const auto& [id, clip] : shown) {
        const TemplateEntry* entry = scene.findTemplate(id);
        if (entry != nullptr && entry->asset && clip < entry->asset->clips.size()) {
            (void)keyframes.clip(entry->asset, clip);
        }
    }
    keyframes.waitForAll();
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
    if (auto allowed = refuseDuringEdit("A stroke"); !allowed) {
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
    bakeAllShown(*now, *m_host.keyframes);
    RecordedStroke recording;
    recording.settings = stroke.settings;
    recording.seed = stroke.seed;
    recording.camera = camera.value();
    recording.viewSize = stroke.viewSize;
    recording.inputs = stroke.inputs;
    if (stroke.settings.kind == BrushKind::Script) {
        return scriptStroke(recording, paint);
    }
    return onDocument([&]() -> Result<StrokeOutcome> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        m_host.stage->setStages(m_host.document->scene().stages);
        return replay(*m_host.document, *m_host.keyframes, *m_host.stage, recording);
    });
}

/// As crowdbrush render has it: simulated up to that time where there is behaviour.
CrowdFramePtr ScriptScene::frameAt(double seconds)
{
    const std::uint64_t now = revision();
    if (m_motion && m_motion->revision != now) {
        m_motion.reset();
    }
    const auto known = scene();
    if (!(seconds > 0.0) || !known->hasBehaviour()) {
        return onDocument([&] { return m_host.document->frame(seconds); });
    }
    if (!m_motion) {
        m_motion = std::make_unique<Motion>(known, now);
    }
    return m_motion->motion.at(seconds);
}

Result<std::vector<std::uint8_t>> ScriptScene::picture(const ScriptPicture& picture)
{
    const auto now = scene();
    const auto camera = cameraOrFirst(*now, picture.camera);
    if (!camera) {
        return camera.error();
    }
    if (!m_pictures) {
        auto maker = PictureMaker::create(m_pictureKeyframes);
        if (!maker) {
            return maker.error();
        }
        m_pictures = std::move(maker).value();
    }
    const std::vector<WorldSeat> seats = now->worldSeats();
    PictureRequest request;
    request.frame = picture.frame ? picture.frame : frameAt(picture.seconds);
    request.stages = now->stages;
    request.seats = seats;
    request.seatsVersion = ++m_pictureCount;
    request.lighting = now->lighting;
    request.camera = camera.value();
    request.size = picture.size;
    request.look = picture.look;
    if (auto drawn = m_pictures->draw(request); !drawn) {
        return drawn.error();
    }
    return m_pictures->pixels();
}

} // namespace crowd::app
