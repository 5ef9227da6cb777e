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
        fields.complain("capacity", QT_TRANSLATE_NOOP("Messages", "%1 must be at most %2"),
                        kMaxPlaceCapacity);
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
        fields.complain("places",
                        QT_TRANSLATE_NOOP("Messages", "%1 must be a list of ids of places"));
        return;
    }
    path.places = places->get<std::vector<PlaceId>>();
}

Path pathFrom(JsonFields fields, const std::string& where, Message& problem)
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

json toJson(const SurfaceSettings& surface)
{
    return withUnknown(surface.unknownMembers, {{"radius", number(surface.radius)},
                                                {"height", number(surface.height)},
                                                {"climb", number(surface.climb)},
                                                {"slope", number(surface.slopeDegrees)}});
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

/// Among entries by ascending id: of many thousands each is looked up.
template<class Entry>
bool isThere(const std::vector<Entry>& entries, std::uint32_t id)
{
    return std::ranges::binary_search(entries, id, {}, &Entry::id);
}

/// Paths may name only places and paths that are there.
void checkNames(const Scene& scene, Message& problem)
{
    for (const Path& path : scene.paths) {
        for (const PlaceId id : path.places) {
            if (!isThere(scene.places, id) && problem.empty()) {
                problem = Message(
                    QT_TRANSLATE_NOOP(
                        "Messages", "paths: \"%1\" (id %2) names the place %3, which is not there"),
                    path.name, path.id, id);
            }
        }
        for (const PathBranch& branch : path.branches) {
            if (!isThere(scene.paths, branch.path) && problem.empty()) {
                problem = Message(
                    QT_TRANSLATE_NOOP(
                        "Messages",
                        "paths: \"%1\" (id %2) branches off to the path %3, which is not there"),
                    path.name, path.id, branch.path);
            }
        }
    }
}

} // namespace

json memberJson(members::Places, const Scene& scene)
{
    json list = json::array();
    for (const Place& place : scene.places) {
        list.push_back(toJson(place));
    }
    return list;
}

void readMember(members::Places, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "places", "", problem, [&scene](JsonFields fields, const std::string&) {
        scene.places.push_back(placeFrom(std::move(fields)));
    });
    sortById(scene.places, "places", problem);
}

json memberJson(members::Paths, const Scene& scene)
{
    json list = json::array();
    for (const Path& path : scene.paths) {
        list.push_back(toJson(path));
    }
    return list;
}

void readMember(members::Paths, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "paths", "", problem,
                [&scene, &problem](JsonFields fields, const std::string& where) {
                    scene.paths.push_back(pathFrom(std::move(fields), where, problem));
                });
    sortById(scene.paths, "paths", problem);
    checkNames(scene, problem);
}

json memberJson(members::Surface, const Scene& scene)
{
    return toJson(scene.surface);
}

void readMember(members::Surface, JsonFields& top, Scene& scene, Message&)
{
    if (const json* surface = top.find("surface")) {
        scene.surface = surfaceFrom(top.part(*surface, "surface"));
    }
}

json memberJson(members::Steps, const Scene& scene)
{
    return scene.stepsPerSecond;
}

void readMember(members::Steps, JsonFields& top, Scene& scene, Message&)
{
    top.read("stepsPerSecond", scene.stepsPerSecond);
    if (std::ranges::find(kStepRates, scene.stepsPerSecond) == kStepRates.end()) {
        top.complain("stepsPerSecond", QT_TRANSLATE_NOOP("Messages", "%1 must be 30, 60 or 120"));
    }
}

} // namespace crowd::model
