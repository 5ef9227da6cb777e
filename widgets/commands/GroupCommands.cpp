// SPDX-License-Identifier: MIT
#include "widgets/commands/GroupCommands.h"

#include <array>

#include <QtCore/QCoreApplication>

#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

using model::BrushKind;
using model::GroupId;

namespace {

struct GroupCommandsText
{
    Q_DECLARE_TR_FUNCTIONS(GroupCommands)
};

/// Told apart at a glance, also in dark themes.
constexpr std::array<model::PaintColor, 8> kColors{{{90, 150, 220},
                                                    {220, 120, 60},
                                                    {90, 180, 90},
                                                    {200, 90, 160},
                                                    {220, 180, 50},
                                                    {110, 100, 210},
                                                    {70, 180, 180},
                                                    {200, 80, 80}}};

/// Of these people; 0: it could not be made.
GroupId makeGroup(EditorState& state, std::span<const model::IndividualId> ids)
{
    GroupId made = 0;
    editGroups(state, GroupCommandsText::tr("New group"), [&](model::SceneEdit& edit) {
        model::Group group;
        group.name =
            model::freeGroupName(edit.scene(), GroupCommandsText::tr("Group").toStdString());
        group.color = kColors[edit.scene().groups.size() % kColors.size()];
        made = model::addGroup(edit, group);
        if (made != 0) {
            model::putInGroup(edit, ids, made);
        }
    });
    return made;
}

} // namespace

GroupId activeGroup(const EditorState& state)
{
    return state.brush(BrushKind::Create).as<model::CreateSettings>().group;
}

void setActiveGroup(EditorState& state, GroupId group)
{
    model::BrushSettings create = state.brush(BrushKind::Create);
    create.as<model::CreateSettings>().group = group;
    state.setBrush(create);
    model::BrushSettings taking = state.brush(BrushKind::Group);
    taking.as<model::GroupSettings>().group = group;
    state.setBrush(taking);
}

void editGroups(EditorState& state, const QString& undoText,
                const std::function<void(model::SceneEdit&)>& apply)
{
    state.document().edit(undoText, apply);
}

void groupSelection(EditorState& state)
{
    const auto selected = state.selection().ids();
    const std::vector<model::IndividualId> ids(selected.begin(), selected.end());
    if (const GroupId made = makeGroup(state, ids); made != 0) {
        setActiveGroup(state, made);
    }
}

void makeFirstGroup(EditorState& state)
{
    model::BrushSettings brush = state.brush(BrushKind::Group);
    if (brush.as<model::GroupSettings>().group == 0 && state.scene().groups.empty()) {
        brush.as<model::GroupSettings>().group = makeGroup(state, {});
        state.setBrush(brush);
    }
}

void putSelectionInGroup(EditorState& state, GroupId group)
{
    const auto selected = state.selection().ids();
    const std::vector<model::IndividualId> ids(selected.begin(), selected.end());
    if (ids.empty()) {
        state.showStatus(GroupCommandsText::tr("Nobody is selected: there is nobody to take in."));
        return;
    }
    editGroups(state,
               GroupCommandsText::tr("Take %n character(s) into a group", nullptr,
                                     static_cast<int>(ids.size())),
               [&](model::SceneEdit& edit) { model::putInGroup(edit, ids, group); });
}

void selectGroup(EditorState& state, GroupId group)
{
    const auto ids = model::peopleWith(state.scene().population, model::columns::group, group);
    state.selection().set(ids);
    const model::Group* known = state.scene().findGroup(group);
    if (known != nullptr && (known->isHidden || known->isLocked) && !ids.empty()) {
        state.showStatus(GroupCommandsText::tr(
            "The group is locked or hidden: its characters cannot be selected."));
    }
}

void deleteGroup(EditorState& state, GroupId group)
{
    editGroups(state, GroupCommandsText::tr("Delete a group"),
               [&](model::SceneEdit& edit) { model::removeGroup(edit, group); });
}

void showGroupAlone(EditorState& state, GroupId group)
{
    editGroups(state, GroupCommandsText::tr("Show a group alone"),
               [&](model::SceneEdit& edit) { model::soloGroup(edit, group); });
}

} // namespace crowd::widgets
