// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::render {

/// Whether the context that is current is drawn by the processor.
[[nodiscard]] bool isSoftwareRenderer();

/// Keeps the C library from giving memory back to the system between frames: a software rasteriser
/// allocates and frees megabytes with each of them. Affects the whole process.
void tuneForSoftwareRendering();

} // namespace crowd::render
