// SPDX-License-Identifier: MIT
#include "widgets/commands/ViewCommands.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>

#include "model/document/SceneEdit.h"
#include "model/scene/LightAim.h"
#include "model/scene/PlaceShape.h"
#include "widgets/state/ShownLook.h"

namespace crowd::widgets {

using model::Bounds;
using model::Camera;
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
    state.document().edit(text,
                          [&](model::SceneEdit& edit) { edit.setCameras(std::move(cameras)); });
}

/// While the timeline is recorded the artist directs it.
void recordCamera(EditorState& state, const NamedCamera& camera)
{
    MarkRecorder& recorder = state.session().recorder();
    model::Mark mark;
    mark.id = state.transport().isPlaying() ? recorder.nextId() : 0;
    if (mark.id != 0) {
        mark.kind = model::MarkKind::Camera;
        mark.seconds = state.transport().seconds();
        mark.camera = camera.name;
        recorder.add({std::move(mark)});
    }
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

constexpr float kOutlierShare = 0.02F; ///< of a stage's points, at each end of each axis

/// The middle part of sorted numbers: what lies between all but the outermost few.
std::pair<float, float> bulkOf(std::vector<float>& values)
{
    const auto few = static_cast<std::ptrdiff_t>(kOutlierShare * static_cast<float>(values.size()));
    const auto low = values.begin() + few;
    const auto high = values.end() - 1 - few;
    std::nth_element(values.begin(), low, values.end());
    const float lowest = *low;
    std::nth_element(values.begin(), high, values.end());
    return {lowest, *high};
}

/// Where a stage has its detail: hills on the horizon and the ground out to them are few points.
Bounds bulkOf(const model::StageEntry& entry)
{
    Bounds bulk;
    std::array<std::vector<float>, 3> axes;
    for (const model::StageMesh& mesh : entry.asset->meshes) {
        for (const glm::vec3& point : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis) {
                axes[static_cast<std::size_t>(axis)].push_back(point[axis]);
            }
        }
    }
    if (axes[0].empty()) {
        return bulk;
    }
    std::array<std::pair<float, float>, 3> ends;
    std::ranges::transform(axes, ends.begin(), [](auto& values) { return bulkOf(values); });
    const glm::mat4 matrix = entry.worldFromStage();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) != 0 ? ends[0].second : ends[0].first,
                              (corner & 2) != 0 ? ends[1].second : ends[1].first,
                              (corner & 4) != 0 ? ends[2].second : ends[2].first);
        bulk.add(glm::vec3(matrix * glm::vec4(point, 1.0F)));
    }
    return bulk;
}

/// As the camera looks, but from so high that what is in front, a stage's back wall say, does not
/// stand before everything else.
Camera overview(const model::Scene& scene, const Camera& camera)
{
    constexpr float kDown = 0.62F; // sine of 38°
    const glm::vec3 forward = camera.forward();
    const glm::vec2 level(forward.x, forward.z);
    if (scene.stages.empty() || camera.projection == model::Projection::Orthographic ||
        -forward.y >= kDown || glm::length(level) < 1e-4F) {
        return camera;
    }
    const glm::vec2 along = glm::normalize(level) * std::sqrt(1.0F - kDown * kDown);
    Camera high = camera;
    high.orientation = Camera::lookingAt({}, {along.x, -kDown, along.y}).orientation;
    return high;
}

void addPlace(Bounds& bounds, const model::Place& place)
{
    const glm::vec3 aside(place.radius, 0.0F, place.radius);
    bounds.add(place.position - aside);
    bounds.add(place.position + aside);
    for (const glm::vec3& corner : model::cornersOf(place)) {
        bounds.add(corner - aside);
        bounds.add(corner + aside);
    }
}

/// The lamp, and where it shines, unless that is far away.
Bounds boundsOf(const model::Light& light)
{
    constexpr float kRoom = 1.5F; // metres
    constexpr float kFar = 12.0F;
    Bounds bounds;
    bounds.add(light.position - glm::vec3(kRoom));
    bounds.add(light.position + glm::vec3(kRoom));
    const auto lit = model::isAimed(light) ? model::aimedAt(light, nullptr) : std::nullopt;
    if (lit && glm::distance(*lit, light.position) < kFar) {
        bounds.add(*lit);
    }
    return bounds;
}

} // namespace

Bounds sceneBounds(const model::Scene& scene)
{
    Bounds bounds;
    for (const model::StageEntry& entry : scene.stages) {
        if (entry.asset) {
            bounds.add(bulkOf(entry));
        }
    }
    for (std::size_t row = 0; row < scene.population.size(); ++row) {
        bounds.add(bodyAt(scene, row));
    }
    for (const model::Place& place : scene.places) {
        addPlace(bounds, place);
    }
    return bounds.isEmpty() ? scene.worldBounds() : bounds;
}

Bounds selectionBounds(const EditorState& state)
{
    Bounds bounds;
    for (const model::IndividualId id : state.selection().ids()) {
        bounds.add(bodyAt(state.scene(), state.scene().population.rowOf(id)));
    }
    for (const model::PlaceId id : state.paths().places()) {
        addPlace(bounds, *state.scene().findPlace(id));
    }
    return bounds;
}

void frameLight(EditorState& state)
{
    const model::Light* light = model::findLight(state.scene().lights, state.chosenLight());
    if (light != nullptr) {
        state.moveCameraTo(framed(state.cameraTarget(), state.viewSize(), boundsOf(*light)));
    }
}

void frameSelection(EditorState& state)
{
    const Bounds bounds = selectionBounds(state);
    if (bounds.isEmpty()) {
        frameAll(state);
        return;
    }
    state.moveCameraTo(framed(state.cameraTarget(), state.viewSize(), bounds));
}

void frameAll(EditorState& state)
{
    state.moveCameraTo(framed(overview(state.scene(), state.cameraTarget()), state.viewSize(),
                              sceneBounds(state.scene())));
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
    showLookOf(state, *found);
    recordCamera(state, *found);
    state.moveCameraTo(found->camera, name);
}

void setCameraLook(EditorState& state, const QString& name, model::LookId look)
{
    const auto found = findCamera(state, name);
    if (found == state.scene().cameras.end() || found->look == look) {
        return;
    }
    std::vector<NamedCamera> cameras = state.scene().cameras;
    cameras[static_cast<std::size_t>(found - state.scene().cameras.begin())].look = look;
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Look of camera “%1”").arg(name));
    if (state.viewCamera().name == name) {
        showLook(state, look);
    }
}

QString freeCameraName(const EditorState& state, const QString& wanted)
{
    QString unique = wanted.trimmed();
    for (int number = 1; unique.isEmpty() || hasCamera(state, unique); ++number) {
        unique = wanted.trimmed().isEmpty()
                     ? ViewCommandsText::tr("View %1").arg(number)
                     : ViewCommandsText::tr("%1 (%2)").arg(wanted.trimmed()).arg(number + 1);
    }
    return unique;
}

QString addCamera(EditorState& state, const QString& name)
{
    QString unique = freeCameraName(state, name);
    std::vector<NamedCamera> cameras = state.scene().cameras;
    cameras.push_back({unique.toStdString(), state.camera()});
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Add camera “%1”").arg(unique));
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
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Update camera “%1”").arg(name));
    state.setCamera(state.camera(), name);
}

void removeCamera(EditorState& state, const QString& name)
{
    std::vector<NamedCamera> cameras = state.scene().cameras;
    std::erase_if(cameras,
                  [&](const NamedCamera& camera) { return camera.name == name.toStdString(); });
    commitCameras(state, std::move(cameras), ViewCommandsText::tr("Remove camera “%1”").arg(name));
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
    model::Timeline timeline = state.scene().timeline;
    for (model::Mark& mark : timeline) {
        if (!mark.camera.empty() && mark.camera == from.toStdString()) {
            mark.camera = wanted.toStdString();
        }
    }
    state.document().edit(ViewCommandsText::tr("Rename camera “%1”").arg(from),
                          [&](model::SceneEdit& edit) {
                              edit.setCameras(std::move(cameras));
                              edit.set<model::members::Timeline>(std::move(timeline));
                          });
    return true;
}

} // namespace crowd::widgets
