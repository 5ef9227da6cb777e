// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/gl/GlObjects.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"

namespace crowd::render {

/// Translucent characters that are not there yet.
class GhostPass
{
public:
    explicit GhostPass(PeopleDrawing& drawing) : m_drawing(drawing) {}

    void initialize();
    [[nodiscard]] model::Result<void> draw(const PassContext& context, CrowdGpu& crowd);

private:
    [[nodiscard]] const TemplateGpu& send(const PassContext& context, CrowdGpu& crowd,
                                          const Ghost& ghost);
    [[nodiscard]] model::Result<void> drawGhost(const PassContext& context, CrowdGpu& crowd,
                                                const Ghost& ghost);

    PeopleDrawing& m_drawing;
    CrowdRows m_rows;
    GlBuffer m_instances;
};

} // namespace crowd::render
