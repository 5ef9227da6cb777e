// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/MeshGroups.h"
#include "render/crowd/TemplateGpu.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

inline constexpr int kPlacementUnit = 0; ///< texture unit of CrowdRows::placement
inline constexpr int kAppearanceUnit = 1;
inline constexpr int kEarlierUnit = 14; ///< of EarlierRows

/// Draws runs of people of any view: the shaders, which are compiled when somebody needs them, and
/// the state of each group of triangles.
class PeopleDrawing
{
public:
    PeopleDrawing();

    struct CrowdDraw
    {
        const CrowdRows& rows;
        const GlBuffer& instances;
        std::string defines{}; ///< added to those of the group
        float opacity = 1.0F;
        Surface surface = Surface::Solid;
        const model::View* seenFrom = nullptr; ///< of a light; else the picture's
    };
    [[nodiscard]] model::Result<void> draw(const PassContext& context, const CrowdDraw& drawing,
                                           const TemplateGpu& gpu, const InstanceRun& run);

private:
    void setUniforms(const PassContext& context, const CrowdDraw& drawing, const TemplateGpu& gpu,
                     ShaderProgram& shader) const;
    void drawGroup(const PassContext& context, const MeshGroup& group,
                   const InstanceRun& run) const;

    [[nodiscard]] model::Result<void> drawCards(const PassContext& context,
                                                const CrowdDraw& drawing, const TemplateGpu& gpu,
                                                const InstanceRun& run);

    void bindInstances(const GlBuffer& instances);

    ShaderVariants m_programs;
    ShaderVariants m_cardPrograms;
    GlTexture m_instanceWords; ///< of those drawn last as cards
};

} // namespace crowd::render
