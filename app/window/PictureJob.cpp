// SPDX-License-Identifier: MIT
#include "app/window/PictureJob.h"

#include <utility>

#include "model/view/PropertyPaint.h"
#include "widgets/state/EditorState.h"
#include "widgets/state/ShownLook.h"

namespace crowd::app {

PictureJob PictureJob::ofView(const widgets::EditorState& state)
{
    const widgets::ViewOptions& options = state.viewOptions();
    const model::Scene& scene = state.scene();
    PictureJob job;
    job.stages = scene.stages;
    job.seats = scene.worldSeats();
    job.property = render::lookInfo(options.look).isByProperty ? options.property : std::string();
    job.request.lighting = scene.lighting;
    job.request.lights = scene.lights;
    job.request.lighting.showGroundGrid &= options.showGroundGrid;
    job.request.camera = state.camera();
    job.request.look = options.look;
    job.request.showShadows = options.showShadows;
    if (const model::LookPreset* look = widgets::shownLook(state)) {
        job.request.ownLook = *look;
    }
    return job;
}

const PictureRequest& PictureJob::ask(const model::Scene& scene, model::CrowdFramePtr frame)
{
    request.frame =
        property.empty() ? std::move(frame) : model::framePaintedBy(scene, *frame, property);
    request.stages = stages;
    request.seats = seats;
    return request;
}

} // namespace crowd::app
