// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>

#include <QtCore/QFileInfo>

#include "app/python/ScriptSceneParts.h"
#include "model/project/AssetPaths.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

using namespace model;

namespace {

/// As entries of a scene hold it.
std::string absolute(const std::string& path)
{
    return isBuiltin(path)
               ? path
               : QFileInfo(QString::fromStdString(path)).absoluteFilePath().toStdString();
}

Error noTemplate(TemplateId id)
{
    return Error{"The scene has no template " + std::to_string(id) +
                 ": take one of scene.templates."};
}

Error noStage(std::uint8_t id)
{
    return Error{"The scene has no stage " + std::to_string(id) + ": take one of scene.stages."};
}

/// Bit by bit: NaN stands for the file's own speed.
bool sameNumbers(const std::vector<float>& a, const std::vector<float>& b)
{
    return std::ranges::equal(a, b, [](float left, float right) {
        return std::bit_cast<std::uint32_t>(left) == std::bit_cast<std::uint32_t>(right);
    });
}

} // namespace

Result<TemplateId> ScriptScene::addTemplate(TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    auto asset = loadTemplateAsset(entry);
    if (!asset) {
        return asset.error();
    }
    if (entry.name.empty()) {
        entry.name = asset.value()->name;
    }
    attachAsset(entry, asset.value());
    return onDocument([&]() -> Result<TemplateId> {
        if (entry.id != 0 && m_host.document->scene().findTemplate(entry.id) != nullptr) {
            return Error{"The scene already has a template " + std::to_string(entry.id) + "."};
        }
        TemplateId id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addTemplate(entry); };
        if (auto done = edit(stepText(QT_TRANSLATE_NOOP("Script", "Add template")), work); !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> ScriptScene::changeTemplate(TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = scene();
    const TemplateEntry* was = now->findTemplate(entry.id);
    if (was == nullptr) {
        return noTemplate(entry.id);
    }
    const bool isSameFile = was->path == entry.path && was->import == entry.import &&
                            sameNumbers(was->clipSpeeds, entry.clipSpeeds) &&
                            was->clipRoles == entry.clipRoles;
    if (!isSameFile) {
        auto asset = loadTemplateAsset(entry);
        if (!asset) {
            return asset.error();
        }
        attachAsset(entry, asset.value());
    }
    return onDocument([&] {
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change template")),
                    [&](SceneEdit& open) { open.changeTemplate(entry); });
    });
}

Result<void> ScriptScene::removeTemplate(TemplateId id)
{
    return onDocument([&]() -> Result<void> {
        const Scene& now = m_host.document->scene();
        if (now.findTemplate(id) == nullptr) {
            return noTemplate(id);
        }
        const auto users = std::ranges::count(now.population.column(columns::templateId), id);
        if (users > 0) {
            return Error{std::to_string(users) + " people are of template " + std::to_string(id) +
                         ": remove them first."};
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove template")),
                    [&](SceneEdit& open) { open.removeTemplate(id); });
    });
}

Result<std::uint8_t> ScriptScene::addStage(StageEntry entry)
{
    entry.path = absolute(entry.path);
    auto asset = loadStageAsset(entry);
    if (!asset) {
        return asset.error();
    }
    entry.asset = asset.value();
    if (entry.name.empty()) {
        entry.name = entry.asset->name;
    }
    return onDocument([&]() -> Result<std::uint8_t> {
        if (entry.id != 0 && m_host.document->scene().findStage(entry.id) != nullptr) {
            return Error{"The scene already has a stage " + std::to_string(entry.id) + "."};
        }
        std::uint8_t id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addStage(entry); };
        if (auto done = edit(stepText(QT_TRANSLATE_NOOP("Script", "Add stage")), work); !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> ScriptScene::changeStage(StageEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = scene();
    const StageEntry* was = now->findStage(entry.id);
    if (was == nullptr) {
        return noStage(entry.id);
    }
    if (was->path != entry.path) {
        auto asset = loadStageAsset(entry);
        if (!asset) {
            return asset.error();
        }
        entry.asset = asset.value();
        entry.problem.clear();
    }
    return onDocument([&] {
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change stage")),
                    [&](SceneEdit& open) { open.changeStage(entry); });
    });
}

Result<void> ScriptScene::removeStage(std::uint8_t id)
{
    return onDocument([&]() -> Result<void> {
        if (m_host.document->scene().findStage(id) == nullptr) {
            return noStage(id);
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove stage")),
                    [&](SceneEdit& open) { open.removeStage(id); });
    });
}

} // namespace crowd::app
