// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewCommands.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>

#include "model/document/SceneEdit.h"

namespace crowd::widgets {

using model::Bounds;
using model::NamedCamera;

namespace {

struct ViewCommandsText
{
    Q_DECLARE_TR_FUNCTIONS(ViewCommands)
};

std::vector<NamedCamera>::const_iterator findCamera(const EditorState& state, const QString& name)
{
    const auto& cameras = state.document().scene().cameras;
    return std::find_if(cameras.begin(), cameras.end(), [&](const NamedCamera& camera) {
        return camera.name == name.toStdString();
    });
}

bool hasCamera(const EditorState& state, const QString& name)
{
    return findCamera(state, name) != state.document().scene().cameras.end();
}

void commitCameras(EditorState& state, std::vector<NamedCamera> cameras, const QString& text)
{
    if (state.document().isEditOpen()) {
        return; // in the middle of a stroke
    }
    auto edit = state.document().beginEdit();
    edit->setCameras(std::move(cameras));
    edit->commit(text);
}

/// Someone's body, whatever the template: what framing one person should show.
Bounds bodyAt(const model::Scene& scene, std::size_t row)
{
    const model::Population& people = scene.population;
    const model::TemplateEntry* entry =
        scene.findTemplate(people.column(model::columns::templateId)[row]);
    const float height = entry != nullptr && entry->asset ? entry->asset->height : 1.8F;
    const glm::vec3 foot = people.column(model::columns::position)[row];
    const float top = height * people.column(model::columns::height)[row];
    const float aside = 0.35F * top;
    Bounds bounds;
    bounds.add(foot - glm::vec3(aside, 0.0F, aside));
    bounds.add(foot + glm::vec3(aside, top, aside));
    return bounds;
}

} // namespace

Bounds selectionBounds(const EditorState& state)
{
    Bounds bounds;
    for (const model::IndividualId id : state.selection().ids()) {
        bounds.add(bodyAt(state.scene(), state.scene().population.rowOf(id)));
    }
    return bounds;
}

void frameSelection(EditorState& state)
{
    const Bounds bounds = selectionBounds(state);
    state.moveCameraTo(framed(state.cameraTarget(), state.viewSize(),
                              bounds.isEmpty() ? state.scene().worldBounds() : bounds));
}

void frameAll(EditorState& state)
{
    state.moveCameraTo(framed(state.cameraTarget(), state.viewSize(), state.scene().worldBounds()));
}

void lookFrom(EditorState& state, ViewDirection direction)
{
    state.moveCameraTo(lookingFrom(state.cameraTarget(), direction));
}

void toggleProjection(EditorState& state)
{
    state.setCamera(withOtherProjection(state.cameraTarget()));
}

void goToCamera(EditorState& state, const QString& name)
{
    const auto found = findCamera(state, name);
    if (found == state.scene().cameras.end()) {
        state.showStatus(ViewCommandsText::tr("There is no camera “%1” in this scene.").arg(name));
        return;
    }
    state.moveCameraTo(found->camera, name);
}

QString addCamera(EditorState& state, const QString& name)
{
    QString unique = name.trimmed();
    for (int number = 1; unique.isEmpty() || hasCamera(state, unique); ++number) {
        unique = name.trimmed().isEmpty()
                     ? ViewCommandsText::tr("View %1").arg(number)
                     : ViewCommandsText::tr("%1 (%2)").arg(name.trimmed()).arg(number + 1);
    }
    std::vector<NamedCamera> cameras = state.scene().cameras;
    cameras.push_back({unique.toStdString(), state.camera()});
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Add Camera “%1”").arg(unique));
    state.setCamera(state.camera(), unique);
    return unique;
}

void updateCamera(EditorState& state, const QString& name)
{
    const auto found = findCamera(state, name);
    if (found == state.scene().cameras.end()) {
        return;
    }
    std::vector<NamedCamera> cameras = state.scene().cameras;
    cameras[static_cast<std::size_t>(found - state.scene().cameras.begin())].camera =
        state.camera();
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Update Camera “%1”").arg(name));
    state.setCamera(state.camera(), name);
}

void removeCamera(EditorState& state, const QString& name)
{
    std::vector<NamedCamera> cameras = state.scene().cameras;
    std::erase_if(cameras,
                  [&](const NamedCamera& camera) { return camera.name == name.toStdString(); });
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Remove Camera “%1”").arg(name));
}

bool renameCamera(EditorState& state, const QString& from, const QString& to)
{
    const QString wanted = to.trimmed();
    const auto found = findCamera(state, from);
    if (wanted.isEmpty() || found == state.scene().cameras.end() || hasCamera(state, wanted)) {
        return false;
    }
    std::vector<NamedCamera> cameras = state.scene().cameras;
    cameras[static_cast<std::size_t>(found - state.scene().cameras.begin())].name =
        wanted.toStdString();
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Rename Camera “%1”").arg(from));
    return true;
}

} // namespace crowd::widgets
