// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentJson.h"

#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::array kRoles{"spot", "obstacle", "attractor", "repeller",
                            "exit", "slow",     "forbidden", "preferred"};
constexpr std::array<const char*, 3> kKinds{"simple", "cyclic", "teleport"};
constexpr float kMaxWeight = 1000.0F;

json toJson(const Place& place)
{
    json object = {{"id", place.id},
                   {"name", place.name},
                   {"position", numbers(place.position)},
                   {"radius", number(place.radius)},
                   {"color", colorText(place.color)}};
    if (place.role != PlaceRole::Spot) {
        object["role"] = kRoles[static_cast<std::size_t>(place.role)];
    }
    if (place.capacity != 0) {
        object["capacity"] = place.capacity;
    }
    if (place.speedShare != Place().speedShare) {
        object["speedShare"] = number(place.speedShare);
    }
    return withUnknown(place.unknownMembers, object);
}

json toJson(const Path& path)
{
    json object = {{"id", path.id},
                   {"name", path.name},
                   {"kind", kKinds[static_cast<std::size_t>(path.kind)]},
                   {"color", colorText(path.color)},
                   {"places", path.places}};
    for (const PathBranch& branch : path.branches) {
        object["branches"].push_back(withUnknown(
            branch.unknownMembers,
            {{"place", branch.place}, {"path", branch.path}, {"weight", number(branch.weight)}}));
    }
    return withUnknown(path.unknownMembers, object);
}

Place placeFrom(JsonFields fields)
{
    Place place;
    fields.require("id", place.id);
    fields.read("name", place.name);
    fields.require("position", place.position);
    readWithin(fields, "radius", kMinPlaceRadius, kMaxPlaceRadius, place.radius);
    readColor(fields, "color", place.color);
    readName(fields, "role", kRoles, place.role);
    fields.read("capacity", place.capacity);
    if (place.capacity > kMaxPlaceCapacity) {
        fields.complain("capacity", "must be at most " + std::to_string(kMaxPlaceCapacity));
    }
    readWithin(fields, "speedShare", kMinSpeedShare, 1.0F, place.speedShare);
    place.unknownMembers = fields.unknown();
    return place;
}

void readPlacesOf(JsonFields& fields, Path& path)
{
    const json* places = fields.find("places");
    if (places == nullptr) {
        return;
    }
    const auto isId = [](const json& id) {
        return id.is_number_unsigned() && id.get<std::uint64_t>() <= 0xFFFFFFFFU;
    };
    if (!places->is_array() || !std::ranges::all_of(*places, isId)) {
        fields.complain("places", "must be a list of ids of places");
        return;
    }
    path.places = places->get<std::vector<PlaceId>>();
}

Path pathFrom(JsonFields fields, const std::string& where, std::string& problem)
{
    Path path;
    fields.require("id", path.id);
    fields.read("name", path.name);
    readName(fields, "kind", kKinds, path.kind);
    readColor(fields, "color", path.color);
    readPlacesOf(fields, path);
    readObjects(fields, "branches", where + ".", problem,
                [&path](JsonFields branch, const std::string&) {
                    PathBranch& read = path.branches.emplace_back();
                    branch.require("place", read.place);
                    branch.require("path", read.path);
                    readWithin(branch, "weight", 0.0F, kMaxWeight, read.weight);
                    read.unknownMembers = branch.unknown();
                });
    path.unknownMembers = fields.unknown();
    return path;
}

SurfaceSettings surfaceFrom(JsonFields fields)
{
    SurfaceSettings surface;
    readWithin(fields, "radius", 0.05F, 5.0F, surface.radius);
    readWithin(fields, "height", 0.2F, 20.0F, surface.height);
    readWithin(fields, "climb", 0.0F, 5.0F, surface.climb);
    readWithin(fields, "slope", 0.0F, 85.0F, surface.slopeDegrees);
    surface.unknownMembers = fields.unknown();
    return surface;
}

/// Ascending ids, none 0, none twice.
template<class Entry>
void sortEntries(std::vector<Entry>& entries, const char* key, std::string& problem)
{
    std::ranges::sort(entries, {}, &Entry::id);
    for (std::size_t i = 0; i < entries.size() && problem.empty(); ++i) {
        if (entries[i].id == 0 || (i > 0 && entries[i].id == entries[i - 1].id)) {
            problem = std::string(key) + ": the id " + std::to_string(entries[i].id) +
                      (entries[i].id == 0 ? " is not allowed" : " is given twice");
        }
    }
}

/// Among entries by ascending id: of many thousands each is looked up.
template<class Entry>
bool isThere(const std::vector<Entry>& entries, std::uint32_t id)
{
    return std::ranges::binary_search(entries, id, {}, &Entry::id);
}

/// Paths may name only places and paths that are there.
void checkNames(const Scene& scene, std::string& problem)
{
    for (const Path& path : scene.paths) {
        const std::string name = "paths: \"" + path.name + "\" (id " + std::to_string(path.id);
        for (const PlaceId id : path.places) {
            if (!isThere(scene.places, id) && problem.empty()) {
                problem = name + ") names the place " + std::to_string(id) + ", which is not there";
            }
        }
        for (const PathBranch& branch : path.branches) {
            if (!isThere(scene.paths, branch.path) && problem.empty()) {
                problem = name + ") branches off to the path " + std::to_string(branch.path) +
                          ", which is not there";
            }
        }
    }
}

} // namespace

json surfaceJson(const SurfaceSettings& surface)
{
    return withUnknown(surface.unknownMembers, {{"radius", number(surface.radius)},
                                                {"height", number(surface.height)},
                                                {"climb", number(surface.climb)},
                                                {"slope", number(surface.slopeDegrees)}});
}

void writeEnvironment(const Scene& scene, json& top)
{
    for (const Place& place : scene.places) {
        top["places"].push_back(toJson(place));
    }
    for (const Path& path : scene.paths) {
        top["paths"].push_back(toJson(path));
    }
    if (scene.surface != SurfaceSettings()) {
        top["surface"] = surfaceJson(scene.surface);
    }
    if (scene.stepsPerSecond != kStepRates.front()) {
        top["stepsPerSecond"] = scene.stepsPerSecond;
    }
}

void readEnvironment(JsonFields& top, Scene& scene, std::string& problem)
{
    readObjects(top, "places", "", problem, [&scene](JsonFields fields, const std::string&) {
        scene.places.push_back(placeFrom(std::move(fields)));
    });
    readObjects(top, "paths", "", problem,
                [&scene, &problem](JsonFields fields, const std::string& where) {
                    scene.paths.push_back(pathFrom(std::move(fields), where, problem));
                });
    if (const json* surface = top.find("surface")) {
        scene.surface = surfaceFrom(top.part(*surface, "surface"));
    }
    top.read("stepsPerSecond", scene.stepsPerSecond);
    if (std::ranges::find(kStepRates, scene.stepsPerSecond) == kStepRates.end()) {
        top.complain("stepsPerSecond", "must be 30, 60 or 120");
    }
    sortEntries(scene.places, "places", problem);
    sortEntries(scene.paths, "paths", problem);
    checkNames(scene, problem);
}

} // namespace crowd::model
