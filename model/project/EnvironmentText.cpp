// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentText.h"

#include <algorithm>
#include <array>

#include "model/project/EnvironmentChecks.h"
#include "model/project/EnvironmentJson.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr std::array kMembers{"places", "paths", "tags", "rules", "numbers", "cues"};
constexpr const char* kSurface = "surface";
constexpr const char* kSteps = "stepsPerSecond";
constexpr int kDeepest = 64; ///< as project files

/// Reading goes down as deep as text is nested, and so does writing what is not known.
bool isTooDeep(const std::string& text)
{
    int depth = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size() && depth <= kDeepest; ++i) {
        const char letter = text[i];
        if (isInText && letter == '\\') {
            ++i;
        } else if (letter == '"') {
            isInText = !isInText;
        } else if (!isInText) {
            depth += letter == '[' || letter == '{' ? 1 : letter == ']' || letter == '}' ? -1 : 0;
        }
    }
    return depth > kDeepest;
}

/// Names of members that the scene keeps without knowing them.
class UnknownNames
{
public:
    explicit UnknownNames(const Scene& scene)
    {
        addAll(scene.places);
        addAll(scene.paths);
        for (const Path& path : scene.paths) {
            addAll(path.branches);
        }
        addAll(scene.rules);
        for (const Rule& rule : scene.rules) {
            add(rule.trigger.unknownMembers);
            addAll(rule.conditions);
            addAll(rule.actions);
            forEachPart(rule, [this](const RuleKind& kind, const void* object) {
                for (const FieldInfo& field : kind.fields) {
                    if (field.is<std::vector<ClipWeight>>()) {
                        addAll(std::get<std::vector<ClipWeight>>(field.get(object)));
                    }
                }
            });
        }
        addAll(scene.tags);
        addAll(scene.numbers);
        addAll(scene.cues);
        add(scene.surface.unknownMembers);
    }
    [[nodiscard]] const JsonFields::Tolerated& names() const { return m_names; }

private:
    template<class Entry>
    void addAll(const std::vector<Entry>& entries)
    {
        for (const Entry& entry : entries) {
            add(entry.unknownMembers);
        }
    }
    void add(const std::string& members)
    {
        if (!members.empty()) {
            const json object = json::parse(members);
            for (const auto& [name, value] : object.items()) {
                m_names.insert(name);
            }
        }
    }

    JsonFields::Tolerated m_names;
};

} // namespace

std::string environmentText(const Scene& scene, const EnvironmentParts& parts)
{
    json all = json::object();
    writeEnvironment(scene, all);
    writeRules(scene, all);
    const std::array isMeant{parts.places, parts.paths,   parts.tags,
                             parts.rules,  parts.numbers, parts.cues};
    json meant = json::object();
    for (std::size_t i = 0; i < kMembers.size(); ++i) {
        if (isMeant[i]) {
            meant[kMembers[i]] = all.contains(kMembers[i]) ? all[kMembers[i]] : json::array();
        }
    }
    if (parts.surface) {
        meant[kSurface] = surfaceJson(scene.surface);
    }
    if (parts.steps) {
        meant[kSteps] = scene.stepsPerSecond;
    }
    return meant.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<void> readEnvironmentText(const std::string& text, Scene& scene, bool isStrict)
{
    if (isTooDeep(text)) {
        return Error{"The environment is nested more than " + std::to_string(kDeepest) + " deep."};
    }
    const json top = json::parse(text, nullptr, false);
    if (top.is_discarded() || !top.is_object()) {
        return Error{"The environment must be an object with lists of places, paths, tags, rules, "
                     "numbers and cues."};
    }
    for (const auto& [name, value] : top.items()) {
        if (name != kSurface && name != kSteps &&
            std::ranges::find(kMembers, name) == kMembers.end()) {
            return Error{"The environment has no \"" + name +
                         "\": there are places, paths, tags, rules, numbers, cues, surface and "
                         "stepsPerSecond."};
        }
    }
    Scene changed = scene;
    if (top.contains("places")) {
        changed.places.clear();
    }
    if (top.contains("paths")) {
        changed.paths.clear();
    }
    if (top.contains("tags")) {
        changed.tags.clear();
    }
    if (top.contains("rules")) {
        changed.rules.clear();
    }
    if (top.contains("numbers")) {
        changed.numbers.clear();
    }
    if (top.contains("cues")) {
        changed.cues.clear();
    }
    std::string problem;
    const UnknownNames kept(scene);
    JsonFields fields(top, "", problem, isStrict ? &kept.names() : nullptr);
    readEnvironment(fields, changed, problem);
    readRules(fields, changed, problem);
    if (isStrict) {
        checkEnvironment(scene, changed, problem);
    }
    if (!problem.empty()) {
        return Error{problem + "."};
    }
    scene = std::move(changed);
    return {};
}

} // namespace crowd::model
