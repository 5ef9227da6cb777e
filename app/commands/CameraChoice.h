// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/base/Result.h"
#include "model/view/CameraTrack.h"

namespace crowd::app {

/// What pictures are taken with, as people ask for it on the command line.
struct CameraChoice
{
    std::string camera; ///< name; empty: as the timeline has it, else the scene's first
    std::string move;   ///< "turntable", or a file with marks of a timeline; empty: none of its own
    double begin = 0.0; ///< seconds of the first picture
    double seconds = 0.0; ///< that all of them take
};

/// An error names what there is, or what is wrong with the file.
[[nodiscard]] model::Result<model::CameraTrack> chosenCamera(const CameraChoice& choice,
                                                             const model::Scene& scene);

} // namespace crowd::app
