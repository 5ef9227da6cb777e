// SPDX-License-Identifier: MIT
#include "widgets/tools/SceneQueries.h"

#include <algorithm>

#include "widgets/commands/TakeCommands.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

/// The ground reaches to the horizon; nothing turns around a point out there.
constexpr float kFarthestAnchor = 400.0F;

} // namespace

SceneQueries::SceneQueries(EditorState& state)
    : m_state(state), m_picker(state.keyframes(), m_stage)
{
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                m_seats.follow(change);
                visitChange(
                    change, [this](const model::StagesChanged&) { m_isStageStale = true; },
                    [this](const model::SceneReplaced&) {
                        m_isStageStale = true;
                        m_picker.forget(); // the old scene's memory is wanted back
                        m_stage.setStages({});
                    });
            });
}

model::View SceneQueries::view() const
{
    return {m_state.camera(), m_state.viewSize()};
}

const model::StageRays& SceneQueries::stage()
{
    if (m_isStageStale) {
        m_stage.setStages(m_state.scene().stages);
        m_isStageStale = false;
    }
    return m_stage;
}

const model::ScenePicker& SceneQueries::picker(double shownSeconds)
{
    (void)stage();
    m_picker.update(m_state.session().frame(shownSeconds), seats(), view());
    return m_picker;
}

model::BrushContext SceneQueries::brushContext()
{
    model::BrushContext context{view(), m_state.keyframes(), stage()};
    context.ground = [&state = m_state] { return state.ground().wait(); };
    SessionControl& session = m_state.session();
    if (session.isPosed()) {
        context.pose = [&session](model::CrowdFrame& frame) { session.pose(frame); };
    }
    if (session.isRunning()) {
        context.sendEvent = [&session](const model::EventSettings& event,
                                       std::span<const model::IndividualId> ids) {
            session.send(event, ids);
        };
    }
    if (session.take() != 0) {
        context.retake = [&state = m_state](const model::RetakeSettings& how,
                                            std::span<const model::IndividualId> ids) {
            return retake(state, ids, how);
        };
    }
    return context;
}

model::BrushContext SceneQueries::hoverContext()
{
    model::BrushContext context = brushContext();
    context.ground = [&state = m_state] { return state.ground().soon(); };
    return context;
}

glm::vec3 SceneQueries::pointUnder(glm::dvec2 pixel, double shownSeconds)
{
    const model::ScenePicker& people = picker(shownSeconds);
    if (const auto hit = people.individualAt(pixel)) {
        return hit->point;
    }
    const model::View now = view();
    const model::Ray ray = now.rayThrough(glm::vec2(pixel));
    const auto surface = people.surfaceAt(pixel);
    const float farthest = std::max(kFarthestAnchor, 4.0F * now.camera().pivotDistance);
    const float depth =
        surface ? glm::dot(surface->point - now.camera().position, now.camera().forward()) : 0.0F;
    if (surface && depth <= farthest) {
        return surface->point;
    }
    // The plane through the pivot, facing the camera.
    const float slant = glm::dot(ray.direction, now.camera().forward());
    const float start = glm::dot(ray.origin - now.camera().position, now.camera().forward());
    return ray.origin + ray.direction * ((now.camera().pivotDistance - start) / slant);
}

std::span<const model::WorldSeat> SceneQueries::seats()
{
    return m_seats.seats(m_state.scene());
}

std::span<const render::Marker> SceneQueries::freeSeats()
{
    return m_seats.freeSeats(
        m_state.scene(), m_state.brush(model::BrushKind::Create).as<model::CreateSettings>().seats);
}

} // namespace crowd::widgets
