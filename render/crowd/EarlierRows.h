// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "render/RenderInput.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/StaticRecords.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// Where somebody stood, and between which keyframes he was: three RGBA32UI texels.
struct EarlierRecord
{
    PlacementRecord placement;
    std::uint32_t keyframeA = 0;
    std::uint32_t keyframeB = 0;
    std::uint32_t boxes = 0; ///< as of an Instance
    float blend = 0.0F;
};
static_assert(sizeof(EarlierRecord) == 48);

/// How everybody of a frame was at an earlier moment, row by row of that frame, on the graphics
/// card. Who was not in the scene then is as he is now.
class EarlierRows
{
public:
    EarlierRows();

    /// Of an input with people and a moment before; waits for clips that are still being baked. The
    /// crowd has been brought up to date with the same input.
    void update(const RenderInput& input, CrowdGpu& crowd);
    void bind(int unit) const { m_records.bind(unit); }

private:
    StaticRecords m_before;
    TexelBuffer m_records;
};

} // namespace crowd::render
