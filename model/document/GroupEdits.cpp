// SPDX-License-Identifier: MIT
#include "model/document/GroupEdits.h"

#include <algorithm>
#include <limits>

namespace crowd::model {

namespace {

GroupId highestGroup(const Scene& scene)
{
    GroupId highest = scene.groups.empty() ? 0 : scene.groups.back().id;
    for (const GroupId group : scene.population.column(columns::group)) {
        highest = std::max(highest, group);
    }
    return highest;
}

bool isNameTaken(const Scene& scene, const std::string& name)
{
    return std::ranges::find(scene.groups, name, &Group::name) != scene.groups.end();
}

} // namespace

GroupId addGroup(SceneEdit& edit, Group group)
{
    const GroupId highest = highestGroup(edit.scene());
    if (highest == std::numeric_limits<GroupId>::max()) {
        return 0;
    }
    group.id = highest + 1;
    changeGroup(edit, group);
    return group.id;
}

void changeGroup(SceneEdit& edit, const Group& group)
{
    std::vector<Group> groups = edit.scene().groups;
    const auto place = std::ranges::lower_bound(groups, group.id, {}, &Group::id);
    if (place != groups.end() && place->id == group.id) {
        *place = group;
    } else {
        groups.insert(place, group);
    }
    edit.setGroups(std::move(groups));
}

void removeGroup(SceneEdit& edit, GroupId id)
{
    putInGroup(edit, peopleWith(edit.scene().population, columns::group, id), 0);
    std::vector<Group> groups = edit.scene().groups;
    std::erase_if(groups, [id](const Group& group) { return group.id == id; });
    edit.setGroups(std::move(groups));
}

void putInGroup(SceneEdit& edit, std::span<const IndividualId> ids, GroupId group)
{
    edit.setColumn(columns::group, ids, std::span<const GroupId>(&group, 1));
}

void soloGroup(SceneEdit& edit, GroupId id)
{
    std::vector<Group> groups = edit.scene().groups;
    const bool isAlone = std::ranges::all_of(
        groups, [id](const Group& group) { return group.isHidden == (group.id != id); });
    for (Group& group : groups) {
        group.isHidden = !isAlone && group.id != id;
    }
    edit.setGroups(std::move(groups));
}

std::string freeGroupName(const Scene& scene, const std::string& wanted)
{
    std::string name = wanted;
    for (int number = 2; isNameTaken(scene, name); ++number) {
        name = wanted + ' ' + std::to_string(number);
    }
    return name;
}

} // namespace crowd::model
