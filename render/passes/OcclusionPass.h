// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <glm/vec2.hpp>

#include "model/base/Result.h"
#include "render/gl/DepthCopy.h"
#include "render/gl/GlObjects.h"
#include "render/gl/PictureTarget.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Darkens corners, and where bodies meet ground and seats, by the depth of what is drawn so far:
/// at half the picture's size, blurred, then over the picture. Where a driver does not offer what
/// it needs, nothing is darkened.
class OcclusionPass
{
public:
    void initialize();
    /// The target is bound before and after.
    [[nodiscard]] model::Result<void> draw(const PassContext& context, const DepthCopy& depths,
                                           const PictureTarget& target);

private:
    [[nodiscard]] glm::ivec2 coarseSize() const;
    [[nodiscard]] bool make();
    [[nodiscard]] model::Result<void> find(const PassContext& context, const DepthCopy& depths);
    [[nodiscard]] model::Result<void> spread(const PassContext& context, std::size_t from,
                                             glm::ivec2 way);
    [[nodiscard]] model::Result<void> apply(const PassContext& context);

    ShaderVariants m_programs{"occlusion"};
    GlVertexArray m_nothing;
    glm::ivec2 m_size{0}; ///< of the picture
    int m_coarseness = 2; ///< pixels to a texel of what is found
    bool m_isUsable = false;
    std::array<GlFramebuffer, 2> m_foundFrames;
    std::array<GlTexture, 2> m_found; ///< openness, depth
};

} // namespace crowd::render
