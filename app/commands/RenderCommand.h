// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace crowd::app {

/// crowdbrush render SCENE --output FILE.png [...]: pictures of a scene without a window. Options
/// as the user gave them, UTF-8; empty: not given.
struct RenderOptions
{
    std::string scene;      ///< .crowd, or a .glb or .gltf to look at
    std::string output;     ///< with a run of # for the frame number where several are drawn
    std::string camera;     ///< name; empty: as the timeline has it, else the scene's first
    std::string cameraMove; ///< see CameraChoice
    std::string take;       ///< name, or "none": as the scene plays; empty: as the scene has it
    std::string size = "1280x720";
    double time = 0.0;  ///< seconds of the transport; of frame 0 where several are drawn
    std::string look;   ///< a style, or one of the scene's looks; empty: the camera's, else lit
    std::string by;     ///< property that people are coloured by; empty: as the look is
    std::string passes; ///< keys of PicturePass with commas between; empty: the colours alone
    std::string frames; ///< see FrameList
    bool isResumed = false;
    bool isTransparent = false;        ///< where neither people nor stages are
    std::optional<double> focusMetres; ///< and the next: depth of field
    std::optional<double> fStop;
    double framesPerSecond = 30.0;
    bool allowsMissing = false; ///< draws without characters and stages that cannot be had
};

/// The exit code: 0, 1 with one line on standard error, or 2 for options that make no sense. Prints
/// where it wrote. Needs no display.
[[nodiscard]] int runRender(const RenderOptions& options);

} // namespace crowd::app
