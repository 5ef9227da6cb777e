// SPDX-License-Identifier: MIT
#include "model/brush/changes/Relation.h"

#include "model/brush/BrushSettings.h"

namespace crowd::model {

namespace {

constexpr float kUsualRadius = 12.0F; ///< logical pixels: one person where they are seen well

} // namespace

void RelationSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.radiusPixels = kUsualRadius;
}

} // namespace crowd::model
