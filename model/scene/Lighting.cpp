// SPDX-License-Identifier: MIT
#include "model/scene/Lighting.h"

namespace crowd::model {

Lighting newLighting()
{
    Lighting light;
    light.shadowStrength = 0.8F;
    light.occlusion = 0.6F;
    light.highlights = 1.0F;
    return light;
}

} // namespace crowd::model
