// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crowd::app {

/// crowdbrush bench render: our drawing against the paper's method, in turn, in one process.
struct BenchRenderOptions
{
    int count = 1000;
    int triangles = 0;             ///< of a figure made in code; 0: the built-in man and woman
    std::string size = "1280x720"; ///< pixels
    std::string detail = "full";   ///< "full" or "levels"
    std::string scene;             ///< a project whose people (the first `count`) are drawn instead
    std::string picture;           ///< writes what both drew to PICTURE-ours.png and -reference.png
    int frames = 40;
    int samples = 4;            ///< per pixel
    bool edges = false;         ///< smooth in the last step; not those of plain frames
    std::string clock = "wall"; ///< "wall" or "cpu": processor time of all threads
    std::string look = "lit";   ///< of ours; plain frames are timed beside it
    std::string light;          ///< a ready-made one; empty: the scene's
    bool json = false;
};

/// The exit code; prints the result, or one line on standard error. Needs no display.
[[nodiscard]] int runBenchRender(const BenchRenderOptions& options);

} // namespace crowd::app
