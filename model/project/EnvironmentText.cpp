// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentText.h"

#include <algorithm>
#include <array>

#include "model/project/EnvironmentJson.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr std::array kMembers{"places", "paths", "tags", "rules", "numbers", "cues"};
constexpr const char* kSurface = "surface";
constexpr const char* kSteps = "stepsPerSecond";

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

Result<void> readEnvironmentText(const std::string& text, Scene& scene)
{
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
    JsonFields fields(top, "", problem);
    readEnvironment(fields, changed, problem);
    readRules(fields, changed, problem);
    if (!problem.empty()) {
        return Error{problem};
    }
    scene = std::move(changed);
    return {};
}

} // namespace crowd::model
