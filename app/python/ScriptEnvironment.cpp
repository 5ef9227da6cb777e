// SPDX-License-Identifier: MIT
#include "app/python/ScriptEnvironment.h"

#include <algorithm>

#include "model/base/ShownText.h"
#include "model/features/FeatureWriting.h"
#include "model/project/EnvironmentText.h"
#include "model/rules/RuleSets.h"

namespace crowd::app {

using namespace model;

namespace {

void putEnvironment(SceneEdit& edit, const Scene& wanted)
{
    edit.setPlacesAndPaths(wanted.places, wanted.paths);
    if (wanted.features != edit.scene().features) {
        changeFeatures(edit, wanted.features, false);
    }
    if (wanted.relationKinds != edit.scene().relationKinds) {
        edit.setRelationKinds(wanted.relationKinds);
    }
    forEachMember([&]<class M>(const M&) {
        if constexpr (M::isEnvironment && M::kind == MemberKind::Value) {
            if (M::of(wanted) != M::of(edit.scene())) {
                edit.set<M>(M::of(wanted));
            }
        }
    });
}

} // namespace

Result<Camera> cameraNamed(const ScriptScene& script, const std::string& name)
{
    const auto now = script.scene();
    const auto found = std::ranges::find(now->cameras, name, &NamedCamera::name);
    if (found != now->cameras.end()) {
        return found->camera;
    }
    std::string names;
    for (const NamedCamera& each : now->cameras) {
        names += (names.empty() ? "" : ", ") + each.name;
    }
    return Error{"There is no camera named \"" + name + "\". " +
                 (names.empty() ? "The scene has none." : "The scene has: " + names + ".")};
}

Result<LookId> lookNamed(const Scene& scene, const std::string& name)
{
    if (name.empty()) {
        return LookId{0};
    }
    if (const LookPreset* look = findLook(scene.looks, name)) {
        return look->id;
    }
    std::string names;
    for (const LookPreset& each : scene.looks) {
        names += (names.empty() ? "" : ", ") + each.name;
    }
    return Error{"There is no look named \"" + name + "\" in the scene. " +
                 (names.empty() ? "It has none." : "It has: " + names + ".")};
}

Result<void> setCamera(ScriptScene& script, const std::string& name, const Camera& camera,
                       const std::optional<std::string>& look)
{
    return script.onDocument([&]() -> Result<void> {
        const auto wanted = lookNamed(script.document().scene(), look.value_or(""));
        if (!wanted) {
            return wanted.error();
        }
        std::vector<NamedCamera> cameras = script.document().scene().cameras;
        const auto found = std::ranges::find(cameras, name, &NamedCamera::name);
        if (found == cameras.end()) {
            cameras.push_back({name, camera, wanted.value()});
        } else {
            found->camera = camera;
            found->look = look ? wanted.value() : found->look;
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Set camera")),
                           [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> removeCamera(ScriptScene& script, const std::string& name)
{
    if (const auto known = cameraNamed(script, name); !known) {
        return known.error();
    }
    return script.onDocument([&] {
        std::vector<NamedCamera> cameras = script.document().scene().cameras;
        std::erase_if(cameras, [&name](const NamedCamera& each) { return each.name == name; });
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove camera")),
                           [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> setCameras(ScriptScene& script, std::vector<NamedCamera> cameras)
{
    return script.onDocument([&] {
        for (NamedCamera& each : cameras) {
            const auto& known = script.document().scene().cameras;
            const auto same = std::ranges::find(known, each.name, &NamedCamera::name);
            if (same != known.end()) {
                each.unknownMembers = same->unknownMembers;
            }
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Set cameras")),
                           [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> setLighting(ScriptScene& script, Lighting lighting)
{
    return script.onDocument([&] {
        lighting.unknownMembers = script.document().scene().lighting.unknownMembers;
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Set lighting")),
                           [&](SceneEdit& open) { open.setLighting(lighting); });
    });
}

Result<void> setEnvironment(ScriptScene& script, const std::string& text, bool isStrict)
{
    return script.onDocument([&]() -> Result<void> {
        Scene wanted = script.document().scene();
        if (auto read = readEnvironmentText(text, wanted, isStrict); !read) {
            return read;
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Set environment")),
                           [&](SceneEdit& open) { putEnvironment(open, wanted); });
    });
}

std::string ruleSetKeys()
{
    std::string all;
    for (const std::string_view key : kRuleSetKeys) {
        all += (all.empty() ? "" : ", ") + std::string(key);
    }
    return all;
}

Result<std::vector<RuleId>> addRuleSet(ScriptScene& script, const std::string& key)
{
    const auto* const found = std::ranges::find(kRuleSetKeys, key);
    if (found == kRuleSetKeys.end()) {
        return Error{"There are no ready-made rules \"" + shortened(key) +
                     "\"; there are: " + ruleSetKeys() + '.'};
    }
    const auto set = static_cast<RuleSet>(found - kRuleSetKeys.begin());
    std::vector<RuleId> ids;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& scene = script.document().scene();
        std::vector<Rule> made = rulesOf(set, scene);
        giveIds(made, scene);
        std::vector<Cue> cues = cuesWith(set, made, scene);
        std::vector<Rule> rules = scene.rules;
        ids.resize(made.size());
        std::ranges::transform(made, ids.begin(), &Rule::id);
        rules.insert(rules.end(), made.begin(), made.end());
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Add rules")),
                           [&](SceneEdit& open) {
                               open.setRules(std::move(rules));
                               open.setCues(std::move(cues));
                           });
    });
    if (!done) {
        return done.error();
    }
    return ids;
}

} // namespace crowd::app
