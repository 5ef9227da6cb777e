// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <algorithm>
#include <new>

#include <glm/gtc/matrix_transform.hpp>
#include <tiny_gltf.h>

#include "model/gltf/ClipAnalysis.h"
#include "model/gltf/GltfAnimations.h"
#include "model/gltf/GltfContainer.h"
#include "model/gltf/GltfFile.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfMeshes.h"
#include "model/gltf/GltfNodes.h"
#include "model/gltf/GltfStage.h"

namespace crowd::model {

namespace {

using gltf::GltfFile;

/// Scale, then rotation, then ground offset.
glm::mat4 correctionOf(const ImportSettings& settings)
{
    const glm::mat4 lift =
        glm::translate(glm::mat4(1.0F), glm::vec3(0.0F, settings.groundOffset, 0.0F));
    return lift * glm::mat4_cast(settings.rotation) *
           glm::scale(glm::mat4(1.0F), glm::vec3(settings.scale));
}

Error cancelled(const std::string& path)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "Importing %1 was cancelled."), path};
}

/// What templates and stages share: meshes, nodes and clips as the file has them.
Result<gltf::SceneNodes> buildAsset(GltfFile& file, Template& asset, const ImportProgress& progress)
{
    const auto report = [&](float fraction) {
        return !progress || progress(0.2F + 0.7F * fraction);
    };
    asset.name = file.name;
    asset.warnings = file.warnings;
    gltf::SceneNodes scene = gltf::collectNodes(*file.model);
    asset.nodes = scene.nodes;
    if (const Result<void> meshes = gltf::buildMeshes(file, scene, asset, report); !meshes) {
        return meshes.error();
    }
    if (const Result<void> clips = gltf::buildClips(file, scene, asset); !clips) {
        return clips.error();
    }
    return scene;
}

/// A template that nobody could see is none: clips without a body, or points and lines alone.
Result<void> checkIsSeen(const GltfFile& file, const Template& asset)
{
    if (!asset.levels.front().indices.empty()) {
        return {};
    }
    return Error{
        file.model->meshes.empty()
            ? QT_TRANSLATE_NOOP("Messages",
                                "it has no mesh, so that nobody made of it could be seen; export "
                                "the file again together with the character's mesh, as triangles")
            : QT_TRANSLATE_NOOP(
                  "Messages",
                  "its scene has no triangles, so that nobody made of it could be seen; export the "
                  "file again together with the character's mesh, as triangles")};
}

/// Runs `import` on the checked file; nothing that it or the file does gets out but a message.
template<class Pointer, class Import>
Result<Pointer> guarded(const std::string& path, const ImportProgress& progress, Import import)
{
    if (progress && !progress(0.0F)) {
        return cancelled(path);
    }
    Result<GltfFile> file = gltf::readGltf(path);
    if (!file) {
        return file.error();
    }
    if (progress && !progress(0.2F)) {
        return cancelled(path);
    }
    try {
        Result<Pointer> result = import(file.value());
        if (result) {
            return result;
        }
        return result.error().message == gltf::kCancelled
                   ? cancelled(path)
                   : gltf::fileError(path, result.error().said);
    } catch (const std::bad_alloc&) {
        return gltf::fileError(path,
                               QT_TRANSLATE_NOOP("Messages", "it needs more memory than there is"));
    } catch (const std::exception& problem) {
        return gltf::fileError(
            path, {QT_TRANSLATE_NOOP("Messages", "it cannot be imported: %1"), problem.what()});
    }
}

} // namespace

FileKind sniffKind(const std::string& path)
{
    const Result<gltf::Container> container = gltf::readContainer(path);
    if (!container) {
        return FileKind::Unknown;
    }
    const Result<gltf::Json> root = gltf::parseJson(container.value().json);
    if (!root) {
        return FileKind::Unknown;
    }
    const bool isAlive =
        gltf::countOf(root.value(), "skins") > 0 || gltf::countOf(root.value(), "animations") > 0;
    return isAlive ? FileKind::Template : FileKind::Stage;
}

Result<TemplatePtr> importTemplate(const std::string& path, const ImportSettings& settings,
                                   const ImportProgress& progress)
{
    return guarded<TemplatePtr>(path, progress, [&](GltfFile& file) -> Result<TemplatePtr> {
        auto asset = std::make_shared<Template>();
        const Result<gltf::SceneNodes> scene = buildAsset(file, *asset, progress);
        if (!scene) {
            return scene.error();
        }
        if (const Result<void> seen = checkIsSeen(file, *asset); !seen) {
            return seen.error();
        }
        asset->rootCorrection = correctionOf(settings);
        gltf::analyseClips(*asset, settings.removeRootMotion);
        if (progress && !progress(1.0F)) {
            return Error{gltf::kCancelled};
        }
        return TemplatePtr(std::move(asset));
    });
}

Result<StagePtr> importStage(const std::string& path, const ImportProgress& progress)
{
    return guarded<StagePtr>(path, progress, [&](GltfFile& file) -> Result<StagePtr> {
        file.wantsReliefs = true; // nobody sees those of people, who are small
        Template asset;
        const Result<gltf::SceneNodes> scene = buildAsset(file, asset, progress);
        if (!scene) {
            return scene.error();
        }
        StagePtr stage = gltf::flattenStage(*file.model, scene.value(), std::move(asset));
        if (progress && !progress(1.0F)) {
            return Error{gltf::kCancelled};
        }
        return stage;
    });
}

} // namespace crowd::model
