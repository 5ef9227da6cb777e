// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentJson.h"

#include "model/project/JsonWriting.h"
#include "model/scene/PlaceShape.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::array kRoles{"spot", "obstacle", "attractor", "repeller",
                            "exit", "slow",     "forbidden", "preferred"};
constexpr std::array<const char*, 3> kKinds{"simple", "cyclic", "teleport"};
constexpr std::array<const char*, 3> kShapes{"round", "line", "area"};
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
    if (place.shape != PlaceShape::Round) {
        object["shape"] = kShapes[static_cast<std::size_t>(place.shape)];
    }
    for (const glm::vec3& corner : place.corners) {
        object["corners"].push_back(numbers(corner));
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

void readCorners(JsonFields& fields, Place& place)
{
    const json* corners = fields.find("corners");
    const bool isList = corners == nullptr || corners->is_array();
    for (std::size_t i = 0; isList && corners != nullptr && i < corners->size(); ++i) {
        const json& corner = (*corners)[i];
        if (!corner.is_array() || corner.size() != 3 ||
            !std::ranges::all_of(corner, &JsonFields::isFinite) || i >= kMostCorners) {
            place.corners.clear();
            break;
        }
        place.corners.emplace_back(corner[0].get<float>(), corner[1].get<float>(),
                                   corner[2].get<float>());
    }
    const bool hasLost = isList && corners != nullptr && place.corners.size() != corners->size();
    if (!isList || hasLost || !isWhole(place)) {
        fields.complain("corners",
                        QT_TRANSLATE_NOOP("Messages",
                                          "%1 must be a list of [x, y, z], metres from the "
                                          "position: 2 or more of a line, 3 or more of an area, at "
                                          "most %2, none farther off than %3"),
                        kMostCorners, kFarthestCorner);
        place.shape = PlaceShape::Round;
        place.corners.clear();
    }
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
    readName(fields, "shape", kShapes, place.shape);
    readCorners(fields, place);
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
