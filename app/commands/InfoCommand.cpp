// SPDX-License-Identifier: MIT
#include "app/commands/InfoCommand.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <nlohmann/json.hpp>

#include <QtCore/QString>

#include "model/gltf/GltfImport.h"
#include "model/gltf/ImportProposal.h"
#include "model/project/AssetPaths.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"
#include "widgets/rules/RuleProblems.h"

namespace crowd::app {

namespace {

using Json = nlohmann::ordered_json;

/// Six decimals: what a float holds of a length in metres.
double sixDecimals(float value)
{
    return std::round(static_cast<double>(value) * 1e6) / 1e6;
}

Json clipsOf(const model::Template& asset)
{
    Json clips = Json::array();
    for (const model::Clip& clip : asset.clips) {
        if (!clip.isMadeUp) {
            Json entry{{"name", clip.name},
                       {"seconds", sixDecimals(clip.seconds)},
                       {"keyframes", clip.keyframeCount()},
                       {"speed_m_s", sixDecimals(clip.speed)},
                       {"loop", clip.loop},
                       {"role", model::keyOf(clip.role)}};
            if (clip.seatHeight) {
                entry["seat_height_m"] = sixDecimals(*clip.seatHeight);
            }
            clips.push_back(std::move(entry));
        }
    }
    return clips;
}

template<class Named>
Json namesOf(const std::vector<Named>& items)
{
    Json names = Json::array();
    for (const Named& item : items) {
        names.push_back(item.name);
    }
    return names;
}

Json englishOf(const std::vector<model::Message>& messages)
{
    Json texts = Json::array();
    for (const model::Message& message : messages) {
        texts.push_back(message.english());
    }
    return texts;
}

Json describe(const model::Template& asset)
{
    const model::Mesh& mesh = asset.levels.front();
    Json levels = Json::array();
    for (const model::Mesh& level : asset.levels) {
        levels.push_back(level.triangleCount());
    }
    Json warnings = englishOf(asset.warnings);
    for (const model::Message& advice : model::proposeImport(asset).reasons) {
        warnings.push_back(advice.english());
    }
    return Json{{"kind", "template"},
                {"name", asset.name},
                {"triangles", mesh.triangleCount()},
                {"vertices", mesh.fileVertexCount},
                {"joints", asset.jointCount},
                {"slots", namesOf(asset.slots)},
                {"clips", clipsOf(asset)},
                {"height_m", sixDecimals(asset.height)},
                {"body_m", Json{{"radius", sixDecimals(asset.footprint.radius)},
                                {"front", sixDecimals(asset.footprint.front)},
                                {"back", sixDecimals(asset.footprint.back)}}},
                {"levels", std::move(levels)},
                {"parts", namesOf(asset.parts)},
                {"default_clip", asset.clips[static_cast<std::size_t>(asset.defaultClip)].name},
                {"warnings", std::move(warnings)}};
}

Json describe(const model::StageAsset& stage)
{
    const glm::vec3 size = stage.bounds.size();
    return Json{{"kind", "stage"},
                {"name", stage.name},
                {"triangles", stage.triangleCount()},
                {"vertices", stage.fileVertexCount},
                {"joints", 0},
                {"slots", namesOf(stage.materials)},
                {"clips", Json::array()},
                {"height_m", sixDecimals(size.y)},
                {"size_m", {sixDecimals(size.x), sixDecimals(size.y), sixDecimals(size.z)}},
                {"seats", stage.seats.size()},
                {"warnings", englishOf(stage.warnings)}};
}

model::Result<Json> describeAsset(const InfoOptions& options)
{
    const bool isTemplate = options.as.empty()
                                ? model::sniffKind(options.file) == model::FileKind::Template
                                : options.as == "template";
    if (isTemplate) {
        const model::Result<model::TemplatePtr> asset = model::importTemplate(options.file);
        return asset ? model::Result<Json>(describe(*asset.value())) : asset.error();
    }
    const model::Result<model::StagePtr> stage = model::importStage(options.file);
    return stage ? model::Result<Json>(describe(*stage.value())) : stage.error();
}

/// Why an entry's asset cannot be had; empty where it can.
std::string problemOf(const model::TemplateEntry& entry)
{
    const auto asset = model::loadTemplateAsset(entry);
    return asset ? std::string() : asset.error().message;
}

/// Loads what the scene stands on, only to say how it fares.
std::size_t checkAssets(const model::Scene& scene, Json& warnings)
{
    const std::vector<std::size_t> alike = model::firstAlike(scene.templates);
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < scene.templates.size(); ++i) {
        const model::TemplateEntry& entry = scene.templates[i];
        problems.push_back(alike[i] < i ? problems[alike[i]] : problemOf(entry));
        if (!problems.back().empty()) {
            warnings.push_back("Template \"" + entry.name + "\": " + problems.back());
        }
    }
    std::size_t seats = 0;
    for (const model::StageEntry& entry : scene.stages) {
        const auto stage = model::loadStageAsset(entry);
        if (stage) {
            seats += stage.value()->seats.size();
        } else {
            warnings.push_back("Stage \"" + entry.name + "\": " + stage.error().message);
        }
    }
    return seats;
}

model::Result<Json> describeScene(const std::string& file)
{
    const model::Result<model::Scene> read = model::readProject(QString::fromStdString(file));
    if (!read) {
        return read.error();
    }
    const model::Scene& scene = read.value();
    Json warnings = englishOf(scene.readWarnings);
    const std::size_t seats = checkAssets(scene, warnings);
    for (const model::Rule& rule : scene.rules) {
        const QString problem = widgets::ruleProblem(scene, rule);
        if (!problem.isEmpty()) {
            warnings.push_back("Rule \"" + rule.name + "\": " + problem.toStdString());
        }
    }
    return Json{{"kind", "scene"},
                {"name", scene.name},
                {"individuals", scene.population.size()},
                {"templates", namesOf(scene.templates)},
                {"stage", namesOf(scene.stages)},
                {"cameras", namesOf(scene.cameras)},
                {"places", scene.places.size()},
                {"paths", scene.paths.size()},
                {"rules", scene.rules.size()},
                {"states", scene.states.size()},
                {"seats", seats},
                {"warnings", std::move(warnings)}};
}

std::string asText(const Json& value)
{
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (!value.is_object()) {
        return value.dump();
    }
    std::string text;
    for (const auto& [key, member] : value.items()) {
        text += (text.empty() ? "" : ", ") + (key == "name" ? "" : key + " ") + asText(member);
    }
    return text;
}

/// One line a member; lists one line an entry.
void printPlain(const Json& info)
{
    for (const auto& [key, value] : info.items()) {
        if (!value.is_array()) {
            std::cout << key << ": " << asText(value) << '\n';
            continue;
        }
        std::cout << key << ":" << (value.empty() ? " none" : "") << '\n';
        for (const Json& entry : value) {
            std::cout << "  " << asText(entry) << '\n';
        }
    }
}

} // namespace

int runInfo(const InfoOptions& given)
{
    InfoOptions options = given;
    if (const QString file = model::assetFile(given.file); !file.isEmpty()) {
        options.file = file.toStdString(); // of what comes with the program
    }
    const bool isScene = options.as.empty() && options.file.ends_with(".crowd");
    const model::Result<Json> info = isScene ? describeScene(options.file) : describeAsset(options);
    if (!info) {
        std::cerr << "crowdbrush info: " << info.error().message << '\n';
        return 1;
    }
    if (options.json) {
        std::cout << info.value().dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    } else {
        printPlain(info.value());
    }
    return 0;
}

} // namespace crowd::app
