// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/pictures/PictureMaker.h"
#include "model/scene/Scene.h"

namespace crowd::widgets {
class EditorState;
} // namespace crowd::widgets

namespace crowd::app {

/// All that pictures of the view show, apart from the document: the artist paints on meanwhile.
struct PictureJob
{
    std::vector<model::StageEntry> stages;
    std::vector<model::WorldSeat> seats;
    PictureRequest request; ///< its spans are set by ask()
    std::string property;   ///< that people are coloured by; empty: none

    /// As the view is drawn now, without marks and handles. Main thread.
    [[nodiscard]] static PictureJob ofView(const widgets::EditorState& state);
    /// The request for a frame of the scene, for as long as this lives.
    [[nodiscard]] const PictureRequest& ask(const model::Scene& scene, model::CrowdFramePtr frame);
};

} // namespace crowd::app
