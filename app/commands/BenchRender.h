// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace crowd::app {

/// crowdbrush bench render: our drawing against the paper's method, in turn, in one process.
struct BenchRenderOptions
{
    int count = 1000;
    std::string field = "near";    ///< or "far": nobody is above 30 pixels of 720
    int triangles = 0;             ///< of a figure made in code; 0: the built-in man and woman
    std::string size = "1280x720"; ///< pixels
    std::string detail = "full";   ///< "full" or "levels"
    std::string scene;             ///< a project whose people (the first `count`) are drawn instead
    std::string picture;           ///< writes what both drew to PICTURE-ours.png and -reference.png
    int frames = 40;
    int samples = 4;                 ///< per pixel
    bool quality = false;            ///< also what is lost beside full detail, see kMostLostPsnr
    std::vector<float> thresholds{}; ///< of levels, pixels, descending; empty: the usual ones
    float impostors = -1.0F;    ///< pixels below which cards are drawn; below 0: as in the window
    bool edges = false;         ///< smooth in the last step; not those of plain frames
    std::string clock = "wall"; ///< "wall" or "cpu": processor time of all threads
    std::string look = "lit";   ///< of ours; plain frames are timed beside it
    std::string light;          ///< a ready-made one; empty: the scene's
    bool json = false;
};

/// What may be lost by levels before somebody sees it: dB and structural similarity beside full
/// detail, both against a picture of four samples each way.
inline constexpr double kMostLostPsnr = 0.6;
inline constexpr double kMostLostSsim = 0.010;

/// The exit code, 1 also where more is lost; prints the result, or one line on standard error.
/// Needs no display.
[[nodiscard]] int runBenchRender(const BenchRenderOptions& options);

} // namespace crowd::app
