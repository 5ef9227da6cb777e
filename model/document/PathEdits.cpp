// SPDX-License-Identifier: MIT
#include "model/document/PathEdits.h"

#include <algorithm>

#include <QtCore/QCoreApplication>

namespace crowd::model {

namespace {

struct Names
{
    Q_DECLARE_TR_FUNCTIONS(Paths)
};

Path newPath(SceneEdit& edit, PathKind kind)
{
    Path path;
    path.kind = kind;
    path.id = edit.addPath(path);
    path.name = Names::tr("Path %1").arg(path.id).toStdString();
    path.color = colorOfPath(path.id);
    return path;
}

/// The path that is there, or a new one.
Path pathToExtend(SceneEdit& edit, PathId id, PathKind kind)
{
    const Path* known = edit.scene().findPath(id);
    return known != nullptr ? *known : newPath(edit, kind);
}

QString numberedPlace(std::ptrdiff_t number)
{
    return Names::tr("Place %1").arg(number);
}

/// The first one is Place 1, whatever obstacles there are.
std::string freePlaceName(const Scene& scene)
{
    const auto isSpot = [](const Place& place) { return place.role == PlaceRole::Spot; };
    const auto spots = std::ranges::count_if(scene.places, isSpot);
    for (auto number = std::max<std::ptrdiff_t>(spots, 1);; ++number) {
        std::string name = numberedPlace(number).toStdString();
        if (std::ranges::find(scene.places, name, &Place::name) == scene.places.end()) {
            return name;
        }
    }
}

PlaceId addNamed(SceneEdit& edit, Place place)
{
    place.id = edit.addPlace(place);
    if (place.name.empty() && place.id != 0) {
        place.name = freePlaceName(edit.scene());
        edit.changePlace(place);
    }
    return place.id;
}

} // namespace

std::array<std::uint8_t, 3> colorOfPath(PathId id)
{
    static constexpr std::array<std::array<std::uint8_t, 3>, 8> kColors{{{240, 150, 40},
                                                                         {70, 150, 230},
                                                                         {90, 190, 90},
                                                                         {220, 80, 120},
                                                                         {160, 110, 220},
                                                                         {60, 190, 180},
                                                                         {210, 190, 60},
                                                                         {200, 110, 70}}};
    return kColors[(id + kColors.size() - 1) % kColors.size()];
}

PathId appendPlace(SceneEdit& edit, PathId id, Place place, PathKind kind)
{
    Path path = pathToExtend(edit, id, kind);
    place.id = 0;
    place.color = path.color;
    path.places.push_back(addNamed(edit, place));
    edit.changePath(path);
    return path.id;
}

PathId appendKnownPlace(SceneEdit& edit, PathId id, PlaceId place, PathKind kind)
{
    Path path = pathToExtend(edit, id, kind);
    path.places.push_back(place);
    edit.changePath(path);
    return path.id;
}

PlaceId insertPlace(SceneEdit& edit, PathId id, std::size_t index, Place place)
{
    Path path = *edit.scene().findPath(id);
    place.id = 0;
    place.color = path.color;
    const PlaceId added = addNamed(edit, place);
    index = std::min(index, path.places.size());
    path.places.insert(path.places.begin() + static_cast<std::ptrdiff_t>(index), added);
    edit.changePath(path);
    return added;
}

PathId addPathOver(SceneEdit& edit, std::span<const PlaceId> places, PathKind kind)
{
    Path path = newPath(edit, kind);
    path.places.assign(places.begin(), places.end());
    edit.changePath(path);
    return path.id;
}

void reversePath(SceneEdit& edit, PathId id)
{
    Path path = *edit.scene().findPath(id);
    std::ranges::reverse(path.places);
    edit.changePath(path);
}

void joinPaths(SceneEdit& edit, PathId first, PathId second)
{
    Path joined = *edit.scene().findPath(first);
    const Path other = *edit.scene().findPath(second);
    joined.places.insert(joined.places.end(), other.places.begin(), other.places.end());
    joined.branches.insert(joined.branches.end(), other.branches.begin(), other.branches.end());
    edit.changePath(joined);
    std::vector<IndividualId> walkers;
    const Population& people = edit.scene().population;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (people.column(columns::path)[row] == second) {
            walkers.push_back(people.ids()[row]);
        }
    }
    edit.setColumn(columns::path, walkers, std::span<const PathId>(&first, 1));
    edit.removePath(second);
}

} // namespace crowd::model
