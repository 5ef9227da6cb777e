// SPDX-License-Identifier: MIT
#include "app/python/ScriptAssets.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <utility>

#include <QtCore/QFileInfo>

#include "model/brush/ClipChoice.h"
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

/// One speed for each clip, or none.
Result<void> checkSpeeds(const TemplateEntry& entry)
{
    if (!entry.clipSpeeds.empty() && entry.clipSpeeds.size() != entry.clipNames.size()) {
        return Error{"clip_speeds has " + std::to_string(entry.clipSpeeds.size()) +
                     " speeds, and template " + entry.name + " has " +
                     std::to_string(entry.clipNames.size()) +
                     " clips: give one for each, in the order of clip_names; None takes the "
                     "file's."};
    }
    return {};
}

/// Where a clip of one file is in another: by name; nothing where it is not there.
std::optional<std::size_t> clipIn(const std::vector<std::string>& names, const TemplateEntry& was,
                                  std::size_t clip)
{
    if (clip >= was.clipNames.size()) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(names, was.clipNames[clip]);
    return found == names.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - names.begin()));
}

/// Speeds that were set before, for the clips of the same names.
std::vector<float> speedsByName(const TemplateEntry& was, const std::vector<std::string>& names)
{
    std::vector<float> speeds(names.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t clip = 0; clip < was.clipSpeeds.size(); ++clip) {
        if (const auto now = clipIn(names, was, clip)) {
            speeds[*now] = was.clipSpeeds[clip];
        }
    }
    return speeds;
}

/// People count clips as their template does: they keep theirs by name, and get the usual one where
/// the new file has none of that name.
void followClips(SceneEdit& edit, const TemplateEntry& was, const TemplateEntry& now)
{
    std::vector<IndividualId> ids;
    std::vector<std::uint16_t> clips;
    std::vector<std::uint16_t> styles;
    const Population& people = edit.scene().population;
    const auto templates = people.column(columns::templateId);
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (templates[row] != now.id) {
            continue;
        }
        const bool isSeated = people.column(columns::seat)[row] != kNoSeat;
        const auto clip = clipIn(now.clipNames, was, people.column(columns::clip)[row]);
        const std::uint16_t style = people.column(columns::walkStyle)[row];
        const auto walk = style == 0 ? std::nullopt : clipIn(now.clipNames, was, style - 1U);
        ids.push_back(people.ids()[row]);
        clips.push_back(clip ? static_cast<std::uint16_t>(*clip) : usualClip(now, isSeated));
        styles.push_back(walk ? static_cast<std::uint16_t>(*walk + 1) : std::uint16_t{0});
    }
    edit.setColumn(columns::clip, ids, std::span<const std::uint16_t>(clips));
    edit.setColumn(columns::walkStyle, ids, std::span<const std::uint16_t>(styles));
}

} // namespace

Result<TemplateId> addTemplate(ScriptScene& script, TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    auto asset = loadTemplateAsset(entry);
    if (!asset) {
        return asset.error();
    }
    if (entry.name.empty()) {
        entry.name = asset.value()->name;
    }
    const std::vector<float> speeds = std::exchange(entry.clipSpeeds, {});
    attachAsset(entry, asset.value());
    if (!speeds.empty()) {
        entry.clipSpeeds = speeds;
        if (auto valid = checkSpeeds(entry); !valid) {
            return valid.error();
        }
        attachAsset(entry, asset.value());
    }
    return script.onDocument([&]() -> Result<TemplateId> {
        if (entry.id != 0 && script.document().scene().findTemplate(entry.id) != nullptr) {
            return Error{"The scene already has a template " + std::to_string(entry.id) + "."};
        }
        TemplateId id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addTemplate(entry); };
        if (auto done = script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Add template")), work);
            !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> changeTemplate(ScriptScene& script, TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = script.scene();
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
        const bool areSpeedsNew = !sameNumbers(was->clipSpeeds, entry.clipSpeeds);
        if (was->path != entry.path) {
            const std::vector<float> speeds = std::exchange(entry.clipSpeeds, {});
            entry.clipNames.clear();
            attachAsset(entry, asset.value()); // its own names
            entry.clipSpeeds = areSpeedsNew || was->clipSpeeds.empty()
                                   ? speeds
                                   : speedsByName(*was, entry.clipNames);
        }
        if (auto valid = checkSpeeds(entry); areSpeedsNew && !valid) {
            return valid.error();
        }
        attachAsset(entry, asset.value());
    }
    return script.onDocument([&]() -> Result<void> {
        if (script.document().scene().findTemplate(entry.id) == nullptr) {
            return noTemplate(entry.id); // it went while the file was read
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Change template")),
                           [&](SceneEdit& open) {
                               const TemplateEntry before = *open.scene().findTemplate(entry.id);
                               open.changeTemplate(entry);
                               if (before.clipNames != entry.clipNames) {
                                   followClips(open, before, entry);
                               }
                           });
    });
}

Result<void> removeTemplate(ScriptScene& script, TemplateId id)
{
    return script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        if (now.findTemplate(id) == nullptr) {
            return noTemplate(id);
        }
        const auto users = std::ranges::count(now.population.column(columns::templateId), id);
        if (users > 0) {
            return Error{std::to_string(users) + " characters are of template " +
                         std::to_string(id) + ": remove them first."};
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove template")),
                           [&](SceneEdit& open) { open.removeTemplate(id); });
    });
}

Result<std::uint8_t> addStage(ScriptScene& script, StageEntry entry)
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
    return script.onDocument([&]() -> Result<std::uint8_t> {
        if (entry.id != 0 && script.document().scene().findStage(entry.id) != nullptr) {
            return Error{"The scene already has a stage " + std::to_string(entry.id) + "."};
        }
        std::uint8_t id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addStage(entry); };
        if (auto done = script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Add stage")), work);
            !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> changeStage(ScriptScene& script, StageEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = script.scene();
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
        entry.problem = {};
    }
    return script.onDocument([&]() -> Result<void> {
        if (script.document().scene().findStage(entry.id) == nullptr) {
            return noStage(entry.id);
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Change stage")),
                           [&](SceneEdit& open) { open.changeStage(entry); });
    });
}

Result<void> removeStage(ScriptScene& script, std::uint8_t id)
{
    return script.onDocument([&]() -> Result<void> {
        if (script.document().scene().findStage(id) == nullptr) {
            return noStage(id);
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove stage")),
                           [&](SceneEdit& open) { open.removeStage(id); });
    });
}

} // namespace crowd::app
