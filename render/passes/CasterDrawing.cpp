// SPDX-License-Identifier: MIT
#include "render/passes/CasterDrawing.h"

namespace crowd::render {

model::Result<void> drawCasters(const PassContext& context, PeopleDrawing& people, CrowdGpu& crowd,
                                const CrowdView& seen)
{
    const PeopleDrawing::CrowdDraw drawing{crowd.rows(), seen.instances(), "", 1.0F,
                                           Surface::Caster};
    for (const InstanceRun& run : seen.runs()) {
        if (auto drawn = people.draw(context, drawing, crowd.gpuOf(run.entry), run); !drawn) {
            return drawn;
        }
    }
    return {};
}

} // namespace crowd::render
