// SPDX-License-Identifier: MIT
#include "model/brush/PropertyChange.h"

#include "model/brush/RelationSharing.h"

namespace crowd::model {

ChangeResult changeProperties(const ChangeRequest& request)
{
    const BrushType& type = brushType(request.settings.kind());
    ChangeResult result = type.change != nullptr ? type.change(request) : ChangeResult();
    if (!result.changed.empty()) {
        shareWithRelated(request, result.changed);
        result.reason = StrokeReason::None;
    }
    return result;
}

} // namespace crowd::model
