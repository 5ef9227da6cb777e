// SPDX-License-Identifier: MIT
#include "model/project/SceneAssets.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <mutex>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>

#include "model/gltf/GltfImport.h"
#include "model/project/AssetPaths.h"
#include "model/project/ProjectFile.h"

namespace crowd::model {

namespace {

constexpr const char* kCancelled = QT_TRANSLATE_NOOP("Messages", "Loading was cancelled.");

std::vector<std::string> clipNamesOf(const Template& asset)
{
    std::vector<std::string> names;
    for (const Clip& clip : asset.clips) {
        names.push_back(clip.name);
    }
    return names;
}

/// The asset's clips in the order of `names`, which are extended by those it has beyond them.
std::shared_ptr<Template> withClipsInOrder(const Template& asset, std::vector<std::string>& names)
{
    auto ordered = std::make_shared<Template>(asset);
    ordered->clips.clear();
    for (const Clip& clip : asset.clips) {
        if (std::ranges::find(names, clip.name) == names.end()) {
            names.push_back(clip.name);
        }
    }
    for (const std::string& name : names) {
        const int index = asset.clipIndex(name);
        Clip clip = asset.clips[static_cast<std::size_t>(index < 0 ? asset.defaultClip : index)];
        if (index < 0) {
            ordered->warnings.emplace_back(
                QT_TRANSLATE_NOOP(
                    "Messages",
                    "The clip \"%1\" is not in the file any more; \"%2\" is played instead."),
                name, clip.name);
            clip.name = name;
        }
        ordered->clips.push_back(std::move(clip));
    }
    const auto newIndex = [&](int old) {
        return old < 0 ? -1 : ordered->clipIndex(asset.clips[static_cast<std::size_t>(old)].name);
    };
    ordered->defaultClip = newIndex(asset.defaultClip);
    ordered->seatedClip = newIndex(asset.seatedClip);
    return ordered;
}

void applySpeeds(const TemplateEntry& entry, Template& asset)
{
    for (std::size_t i = 0; i < std::min(entry.clipSpeeds.size(), asset.clips.size()); ++i) {
        if (!std::isnan(entry.clipSpeeds[i])) {
            asset.clips[i].speed = entry.clipSpeeds[i];
        }
    }
}

/// The clip of a role by the artist's roles: the usual one as long as it is of that role.
int clipOfRole(const TemplateEntry& entry, const Template& asset, int usual, ClipRole wanted)
{
    const auto roleOf = [&](std::size_t i) {
        const bool isChosen = i < entry.clipRoles.size() && entry.clipRoles[i].has_value();
        return isChosen ? *entry.clipRoles[i] : asset.clips[i].role;
    };
    if (usual >= 0 && roleOf(static_cast<std::size_t>(usual)) == wanted) {
        return usual;
    }
    for (std::size_t i = 0; i < asset.clips.size(); ++i) {
        if (roleOf(i) == wanted) {
            return static_cast<int>(i);
        }
    }
    return usual;
}

/// How it stands and how it sits by the artist's roles.
TemplatePtr withRoles(const TemplateEntry& entry, TemplatePtr asset)
{
    const int standing = clipOfRole(entry, *asset, asset->defaultClip, ClipRole::Idle);
    const int seated = clipOfRole(entry, *asset, asset->seatedClip, ClipRole::Sit);
    if (entry.clipRoles.empty() ||
        (standing == asset->defaultClip && seated == asset->seatedClip)) {
        return asset;
    }
    auto changed = std::make_shared<Template>(*asset);
    changed->defaultClip = standing;
    changed->seatedClip = seated;
    return changed;
}

ImportProgress importProgress(const LoadProgress& progress, const std::string& what)
{
    if (!progress) {
        return {};
    }
    return [progress, what](float fraction) { return progress(what, fraction); };
}

TemplateEntry builtinTemplate(TemplateId id, const std::string& name)
{
    TemplateEntry entry;
    entry.id = id;
    entry.name = name;
    entry.path = "builtin:templates/" + name + ".glb";
    return entry;
}

std::vector<TemplateEntry> builtinTemplates(std::initializer_list<const char*> names)
{
    std::vector<TemplateEntry> entries;
    for (const char* name : names) {
        entries.push_back(builtinTemplate(static_cast<TemplateId>(entries.size() + 1), name));
    }
    return entries;
}

/// The file to read, or why there can be none.
Result<std::string> fileOf(const std::string& path)
{
    const QString file = assetFile(path);
    if (isBuiltin(path) && builtinFolder().isEmpty()) {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages", "%1: the built-in models were not found. Install them beside "
                                     "the program or name their folder in CROWDBRUSH_RESOURCES."),
                     path};
    }
    if (file.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages", "%1: there is no such built-in model. Locate a file instead."),
                     path};
    }
    return file.toStdString();
}

/// Built-in templates, which do not change while the program runs: scenes share them, and with them
/// what is baked of them, for as long as somebody keeps one.
class BuiltinTemplates
{
public:
    TemplatePtr find(const std::string& file, const ImportSettings& import)
    {
        const std::lock_guard<std::mutex> guard(m_mutex);
        for (const Known& known : m_known) {
            if (TemplatePtr asset = known.asset.lock();
                asset && known.file == file && known.import == import) {
                return asset;
            }
        }
        return nullptr;
    }

    void keep(const std::string& file, const ImportSettings& import, const TemplatePtr& asset)
    {
        const std::lock_guard<std::mutex> guard(m_mutex);
        std::erase_if(m_known, [](const Known& known) { return known.asset.expired(); });
        m_known.push_back({file, import, asset});
    }

private:
    struct Known
    {
        std::string file;
        ImportSettings import;
        std::weak_ptr<const Template> asset;
    };
    std::mutex m_mutex;
    std::vector<Known> m_known;
};

} // namespace

std::vector<std::size_t> firstAlike(const std::vector<TemplateEntry>& entries)
{
    std::vector<std::size_t> first;
    std::map<std::string, std::vector<std::size_t>> ofPath; ///< with settings that differ
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::vector<std::size_t>& known = ofPath[entries[i].path];
        const auto found = std::ranges::find_if(
            known, [&](std::size_t other) { return entries[other].import == entries[i].import; });
        first.push_back(found == known.end() ? i : *found);
        if (found == known.end()) {
            known.push_back(i);
        }
    }
    return first;
}

Result<TemplatePtr> loadTemplateAsset(const TemplateEntry& entry, const LoadProgress& progress)
{
    static BuiltinTemplates builtins;
    const Result<std::string> file = fileOf(entry.path);
    if (!file) {
        return file.error();
    }
    if (TemplatePtr known =
            isBuiltin(entry.path) ? builtins.find(file.value(), entry.import) : nullptr) {
        return known;
    }
    Result<TemplatePtr> asset =
        importTemplate(file.value(), entry.import, importProgress(progress, entry.name));
    if (asset && isBuiltin(entry.path)) {
        builtins.keep(file.value(), entry.import, asset.value());
    }
    return asset;
}

Result<StagePtr> loadStageAsset(const StageEntry& entry, const LoadProgress& progress)
{
    const Result<std::string> file = fileOf(entry.path);
    return file ? importStage(file.value(), importProgress(progress, entry.name)) : file.error();
}

void attachAsset(TemplateEntry& entry, TemplatePtr asset)
{
    std::vector<std::string> names = clipNamesOf(*asset);
    const bool isInOrder = entry.clipNames.empty() || entry.clipNames == names;
    if (!isInOrder || !entry.clipSpeeds.empty()) {
        if (!entry.clipNames.empty()) {
            names = entry.clipNames;
        }
        const auto ordered = withClipsInOrder(*asset, names);
        applySpeeds(entry, *ordered);
        asset = ordered;
    }
    entry.clipNames = names;
    entry.asset = withRoles(entry, std::move(asset));
    entry.problem = {};
}

void loadAssets(Scene& scene, const LoadProgress& progress)
{
    const std::size_t total = scene.templates.size() + scene.stages.size();
    std::size_t done = 0;
    bool isCancelled = false;
    // Progress of the whole; remembers a refusal so that the rest is not even begun.
    const LoadProgress overall = [&](const std::string& what, float fraction) {
        const float all = (static_cast<float>(done) + fraction) / static_cast<float>(total);
        isCancelled = isCancelled || (progress && !progress(what, all));
        return !isCancelled;
    };
    for (StageEntry& entry : scene.stages) {
        if (!entry.asset && overall(entry.name, 0.0F)) {
            Result<StagePtr> asset = loadStageAsset(entry, overall);
            entry.asset = asset ? asset.value() : nullptr;
            entry.problem = asset ? Message() : asset.error().said;
        } else if (!entry.asset) {
            entry.problem = kCancelled;
        }
        ++done;
    }
    const std::vector<std::size_t> alike = firstAlike(scene.templates);
    std::map<std::size_t, Result<TemplatePtr>> loaded; ///< by the first of those that are alike
    for (std::size_t i = 0; i < scene.templates.size(); ++i) {
        TemplateEntry& entry = scene.templates[i];
        if (!entry.asset && overall(entry.name, 0.0F)) {
            auto found = loaded.find(alike[i]);
            if (found == loaded.end()) {
                found = loaded.emplace(alike[i], loadTemplateAsset(entry, overall)).first;
            }
            if (const Result<TemplatePtr>& asset = found->second; asset) {
                attachAsset(entry, asset.value());
            } else {
                entry.problem = asset.error().said;
            }
        } else if (!entry.asset) {
            entry.problem = kCancelled;
        }
        ++done;
    }
}

Result<Scene> loadScene(const QString& path, const LoadProgress& progress)
{
    Result<Scene> scene = readProject(path);
    if (scene) {
        loadAssets(scene.value(), progress);
    }
    return scene;
}

std::vector<TemplateEntry> builtinCast()
{
    const QDir folder(builtinFolder() + QStringLiteral("/templates"));
    std::vector<TemplateEntry> entries;
    for (const QFileInfo& file :
         folder.entryInfoList({QStringLiteral("*.glb")}, QDir::Files, QDir::Name)) {
        entries.push_back(builtinTemplate(static_cast<TemplateId>(entries.size() + 1),
                                          file.completeBaseName().toStdString()));
    }
    return entries;
}

Scene newEmptyGround()
{
    Scene scene;
    scene.templates = builtinTemplates(
        {"man", "woman", "man_2", "woman_2", "boy", "girl", "old_man", "old_woman"});
    scene.cameras.push_back(
        {"Overview", Camera::lookingAt({0.0F, 6.0F, 16.0F}, {0.0F, 0.8F, 0.0F})});
    scene.cameras.push_back(
        {"Eye level", Camera::lookingAt({0.0F, 1.7F, 9.0F}, {0.0F, 1.0F, 0.0F})});
    return scene;
}

Scene newEmptyTheatre()
{
    Scene scene = newEmptyGround();
    scene.templates = builtinTemplates({"patrician", "matron", "citizen", "labourer", "priest"});
    StageEntry theatre;
    theatre.id = 1;
    theatre.name = "theatre";
    theatre.path = "builtin:stages/theatre.glb";
    scene.stages.push_back(theatre);
    scene.cameras = {
        {"Audience", Camera::lookingAt({0.0F, 7.5F, 5.0F}, {0.0F, 1.2F, -13.0F})},
        {"Overview", Camera::lookingAt({24.0F, 20.0F, 16.0F}, {0.0F, 0.5F, -6.0F})},
        {"From the seats", Camera::lookingAt({0.0F, 6.5F, -17.5F}, {0.0F, 2.0F, 6.0F})},
    };
    return scene;
}

} // namespace crowd::model
