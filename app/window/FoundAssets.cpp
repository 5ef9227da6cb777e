// SPDX-License-Identifier: MIT
#include "app/window/FoundAssets.h"

namespace crowd::app {

namespace {

using model::Result;

Result<void> addFound(const model::Scene& scene, const model::MissingAsset& item,
                      const std::string& file, const model::LoadProgress& progress,
                      FoundAssets& found)
{
    if (item.isStage) {
        model::StageEntry entry = *scene.findStage(static_cast<std::uint8_t>(item.id));
        entry.path = file;
        const Result<model::StagePtr> asset = model::loadStageAsset(entry, progress);
        if (!asset) {
            return asset.error();
        }
        found.stages.push_back({entry.id, file, asset.value()});
        return {};
    }
    model::TemplateEntry entry = *scene.findTemplate(static_cast<model::TemplateId>(item.id));
    entry.path = file;
    const Result<model::TemplatePtr> asset = model::loadTemplateAsset(entry, progress);
    if (!asset) {
        return asset.error();
    }
    found.templates.push_back({entry.id, file, asset.value()});
    return {};
}

} // namespace

model::Result<FoundAssets> findAssets(const model::Scene& scene, const model::MissingAsset& asset,
                                      const std::string& path, const model::LoadProgress& progress)
{
    std::vector<model::MissingAsset> wanted = model::missingAssets(scene);
    std::erase_if(wanted, [&asset](const model::MissingAsset& other) {
        return other.isStage == asset.isStage && other.id == asset.id;
    });
    wanted.insert(wanted.begin(), asset);
    FoundAssets found;
    for (const model::MissingAsset& item : wanted) {
        const bool isFirst = &item == &wanted.front();
        const std::string file = isFirst ? path : model::movedAlong(item.path, asset.path, path);
        if (file.empty() || (progress && !progress(item.name, 0.0F))) {
            continue;
        }
        const model::Result<void> added = addFound(scene, item, file, progress, found);
        if (!added && isFirst) {
            return added.error();
        }
    }
    return found;
}

} // namespace crowd::app
