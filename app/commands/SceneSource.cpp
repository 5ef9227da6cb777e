// SPDX-License-Identifier: MIT
#include "app/commands/SceneSource.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <QtCore/QFileInfo>

#include "model/gltf/GltfImport.h"
#include "model/project/AssetPaths.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

namespace {

using namespace model;

/// In front, to the side and a little above, everything in view.
NamedCamera cameraAround(const Bounds& bounds)
{
    const float radius = std::max(glm::length(bounds.size()) * 0.5F, 0.5F);
    Camera camera;
    const float distance = radius * 1.1F / std::sin(camera.fovYRadians * 0.5F);
    const glm::vec3 from =
        bounds.center() + distance * glm::normalize(glm::vec3(0.45F, 0.35F, 1.0F));
    return {"overview", Camera::lookingAt(from, bounds.center())};
}

Result<Scene> loadLoneTemplate(const std::string& path)
{
    auto asset = importTemplate(path);
    if (!asset) {
        return asset.error();
    }
    Scene scene;
    TemplateEntry& entry = scene.templates.emplace_back();
    entry.id = 1;
    entry.name = asset.value()->name;
    entry.path = path;
    attachAsset(entry, asset.value());
    IndividualRows rows = IndividualRows::withDefaults({1});
    rows.column(columns::templateId)[0] = 1;
    rows.column(columns::clip)[0] = static_cast<std::uint16_t>(entry.asset->defaultClip);
    scene.population.add(rows);
    scene.nextId = 2;
    scene.cameras.push_back(cameraAround(entry.asset->bounds));
    return scene;
}

Result<Scene> loadLoneStage(const std::string& path)
{
    auto asset = importStage(path);
    if (!asset) {
        return asset.error();
    }
    Scene scene;
    StageEntry& entry = scene.stages.emplace_back();
    entry.id = 1;
    entry.name = asset.value()->name;
    entry.path = path;
    entry.asset = asset.value();
    scene.cameras.push_back(cameraAround(scene.worldBounds()));
    return scene;
}

} // namespace

Result<Scene> loadForPicture(const QString& path)
{
    const QFileInfo file(assetFile(path.toStdString()));
    if (!file.exists()) {
        return Error{path.toStdString() + " does not exist. Check the name and the folder."};
    }
    const QString absolute = file.absoluteFilePath();
    if (file.suffix().compare(QStringLiteral("crowd"), Qt::CaseInsensitive) == 0) {
        auto scene = loadScene(absolute);
        if (scene && scene.value().cameras.empty()) {
            scene.value().cameras.push_back(cameraAround(scene.value().worldBounds()));
        }
        return scene;
    }
    const std::string name = absolute.toStdString();
    return sniffKind(name) == FileKind::Stage ? loadLoneStage(name) : loadLoneTemplate(name);
}

Result<TemplatePtr> loadBuiltinTemplate(const std::string& name)
{
    return importTemplate(assetFile(name).toStdString());
}

} // namespace crowd::app
