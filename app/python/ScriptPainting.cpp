// SPDX-License-Identifier: MIT
#include "app/python/ScriptPainting.h"

#include <set>

#include "app/python/BrushRules.h"
#include "app/python/ScriptPictures.h"

namespace crowd::app {

using namespace model;

namespace {

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

Result<StrokeOutcome> scriptStroke(ScriptScene& script, const RecordedStroke& recording,
                                   const PaintWork& paint)
{
    const auto link = std::make_shared<ScriptStrokeLink>();
    const auto begun = script.onDocument([&]() -> Result<void> {
        if (auto allowed = script.refuseDuringStroke(); !allowed) {
            return allowed;
        }
        script.stage().setStages(script.document().scene().stages);
        BrushContext context{View(recording.camera, recording.viewSize), script.keyframes(),
                             script.stage()};
        context.script = link.get();
        auto stroke = Stroke::begin(script.document(), context, recording.settings, recording.seed,
                                    recording.inputs.front());
        if (!stroke) {
            return Error{"Something else is being edited: try again when that has ended."};
        }
        for (std::size_t i = 1; i < recording.inputs.size(); ++i) {
            stroke->move(recording.inputs[i]);
        }
        stroke->settle();
        script.holdStroke(std::move(stroke));
        return {};
    });
    if (!begun) {
        return begun.error();
    }
    link->close();
    script.joinStroke(link);
    try {
        paint(*link);
    } catch (...) {
        script.leaveStroke();
        script.dropStroke(); // takes back what was painted
        throw;
    }
    script.leaveStroke();
    return script.onDocument([&]() -> Result<StrokeOutcome> {
        const auto stroke = script.takeStroke();
        if (!stroke) {
            return Error{"The stroke was taken back."};
        }
        return stroke->finish();
    });
}

} // namespace

Result<StrokeOutcome> paintStroke(ScriptScene& script, const ScriptStroke& stroke,
                                  const PaintWork& paint)
{
    if (auto allowed = script.onDocument([&script] { return script.refuseDuringEdit("A stroke"); });
        !allowed) {
        return allowed.error();
    }
    const auto now = script.scene();
    const auto camera = cameraOrFirst(*now, stroke.camera);
    if (!camera) {
        return camera.error();
    }
    if (auto valid = checkBrush(*now, stroke.settings); !valid) {
        return valid.error();
    }
    // A stroke sees people as they are, not as they stand in until they are baked.
    if (!bakeAllShown(*now, script.keyframes(), script.isOfThisProcess())) {
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
        return scriptStroke(script, recording, paint);
    }
    if (stroke.settings.kind() == BrushKind::Create &&
        !stroke.settings.as<CreateSettings>().anywhere) {
        (void)script.ground().of(*now); // takes long: not while a host waits
    }
    return script.onDocument([&]() -> Result<StrokeOutcome> {
        if (auto allowed = script.refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        script.stage().setStages(script.document().scene().stages);
        return replay(script.document(), script.keyframes(), script.stage(), recording,
                      [&script] { return script.ground().of(script.document().scene()); });
    });
}

} // namespace crowd::app
