// SPDX-License-Identifier: MIT
#include "app/python/BrushRules.h"

#include "app/python/ScriptFeatures.h"
#include "app/python/ScriptRelations.h"

#include <algorithm>
#include <limits>
#include <string>

#include "app/python/ColumnRules.h"
#include "model/brush/FeatureBrush.h"
#include "model/describe/FieldChecks.h"
#include "model/scene/NearestPath.h"

namespace crowd::app {

using namespace model;

namespace {

/// Of its settings' names in messages.
std::string prefixOf(const BrushType& type)
{
    const std::string section = type.info.scriptName;
    return section.empty() ? "brush." : "brush." + section + ".";
}

Result<void> checkTemplate(const Scene& scene, std::int64_t id, const std::string& name)
{
    constexpr std::int64_t kMost = std::numeric_limits<TemplateId>::max();
    if (id > kMost || scene.findTemplate(static_cast<TemplateId>(id)) == nullptr) {
        return Error{name + " names template " + std::to_string(id) +
                     ", which the scene does not have: take one of scene.templates."};
    }
    return {};
}

Result<void> checkTemplates(const Scene& scene, const std::vector<int>& ids,
                            const std::string& name)
{
    for (const int id : ids) {
        if (auto valid = checkTemplate(scene, id, name); !valid) {
            return valid;
        }
    }
    return {};
}

Result<void> checkMix(const Scene& scene, const std::vector<TemplateWeight>& mix,
                      const std::string& name)
{
    for (const TemplateWeight& each : mix) {
        if (auto valid = checkTemplate(scene, each.id, name); !valid) {
            return valid;
        }
    }
    return {};
}

Result<void> checkClips(const Scene& scene, const std::vector<ClipWeight>& clips,
                        const std::string& name)
{
    const auto isKnown = [&scene](const ClipWeight& clip) {
        return std::ranges::any_of(scene.templates, [&clip](const TemplateEntry& entry) {
            return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
        });
    };
    if (!clips.empty() && std::ranges::none_of(clips, isKnown)) {
        return Error{name + " names the clip \"" + clips.front().clip +
                     "\", which no template of the scene has."};
    }
    return {};
}

Result<void> checkPath(const Scene& scene, std::int64_t path, const std::string& name)
{
    if (path != 0 && path != kNearestPath && scene.findPath(static_cast<PathId>(path)) == nullptr) {
        return Error{name + " is " + std::to_string(path) +
                     ", which the scene does not have: take one of environment[\"paths\"]."};
    }
    return {};
}

Result<void> checkGroup(const Scene& scene, std::int64_t group, const std::string& name)
{
    if (group != 0 && scene.findGroup(static_cast<GroupId>(group)) == nullptr) {
        return Error{name + " names group " + std::to_string(group) +
                     ", which the scene does not have. " + knownGroups(scene)};
    }
    return {};
}

Result<void> checkState(const Scene& scene, std::int64_t state, const std::string& name)
{
    if (state != 0 && std::ranges::find(scene.states, state, &State::id) == scene.states.end()) {
        return Error{name + " is " + std::to_string(state) +
                     ", which the scene does not have: take State.id of one of scene.states."};
    }
    return {};
}

Result<void> checkMask(const Scene& scene, const MaskSettings& mask)
{
    for (const int group : mask.groups) {
        if (auto valid = checkGroup(scene, group, "brush.mask.groups"); !valid) {
            return valid;
        }
    }
    for (const int id : mask.features) {
        if (findFeature(scene.features, static_cast<FeatureId>(id)) == nullptr) {
            return Error{"brush.mask.features: the scene has no feature with the id " +
                         std::to_string(id) + "; scene.features has their values."};
        }
    }
    return checkTemplates(scene, mask.templates, "brush.mask.templates");
}

Result<void> checkRelation(const Scene& scene, const std::string& kind, const std::string& name)
{
    if (findRelation(scene.relationKinds, kind) == nullptr) {
        return Error{name + ": " + noRelationText(scene.relationKinds, kind)};
    }
    return {};
}

/// Kind and values of a brush of features.
Result<void> checkFeatures(const Scene& scene, const BrushType& type, const BrushSettings& brush)
{
    const FeatureSettings& settings = *featureSettings(brush);
    const FeatureKind* kind = findKind(scene.features, settings.kind);
    if (kind == nullptr) {
        return Error{prefixOf(type) + "kind: " + noKindText(scene.features, settings.kind)};
    }
    for (const ClipWeight& each : settings.values) {
        if (kind->find(each.clip) == nullptr) {
            return Error{prefixOf(type) + "values: " + noValueText(*kind, each.clip)};
        }
    }
    return {};
}

/// What the scene must have for the fields that refer to something.
Result<void> checkSettings(const Scene& scene, const BrushType& type, const BrushSettings& brush)
{
    const std::string prefix = prefixOf(type);
    for (const FieldInfo& field : type.fields) {
        if (field.isGroup()) {
            continue;
        }
        const std::string name = prefix + field.meta.key;
        const FieldValue value = field.get(type.settings(brush));
        Result<void> valid;
        if (const auto* mix = std::get_if<std::vector<TemplateWeight>>(&value)) {
            valid = checkMix(scene, *mix, name);
        } else if (field.meta.role == FieldRole::RelationKind) {
            valid = checkRelation(scene, std::get<std::string>(value), name);
        } else if (field.meta.role == FieldRole::FeatureKind) {
            valid = checkFeatures(scene, type, brush);
        } else if (field.meta.role == FieldRole::Feature) {
            continue; // with the kind
        } else if (const auto* clips = std::get_if<std::vector<ClipWeight>>(&value)) {
            valid = checkClips(scene, *clips, name);
        } else if (field.meta.role == FieldRole::Template) {
            valid = checkTemplates(scene, std::get<std::vector<int>>(value), name);
        } else if (field.meta.role == FieldRole::Path) {
            valid = checkPath(scene, std::get<std::int64_t>(value), name);
        } else if (field.meta.role == FieldRole::Group) {
            valid = checkGroup(scene, std::get<std::int64_t>(value), name);
        } else if (field.meta.role == FieldRole::State) {
            valid = checkState(scene, std::get<std::int64_t>(value), name);
        }
        if (!valid) {
            return valid;
        }
    }
    return {};
}

} // namespace

Result<void> checkBrush(const BrushSettings& brush)
{
    const BrushType& type = brushType(brush.kind());
    if (*type.info.scriptKind == '\0') {
        return Error{"A brush of this kind makes no strokes in scripts: send events with "
                     "session.send, and change places and paths with set_environment."};
    }
    if (auto valid = checkFields(fieldsOf<BrushSettings>(), &brush, "brush."); !valid) {
        return valid;
    }
    return checkFields(type.fields, type.settings(brush), prefixOf(type));
}

Result<void> checkReferences(const Scene& scene, const BrushSettings& brush)
{
    if (auto valid = checkMask(scene, brush.mask); !valid) {
        return valid;
    }
    return checkSettings(scene, brushType(brush.kind()), brush);
}

} // namespace crowd::app
