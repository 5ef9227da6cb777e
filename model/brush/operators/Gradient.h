// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/operators/OperatorRequest.h"

namespace crowd::model {

/// From the lowest value at the press to the highest where the pointer is, by the place on screen.
struct GradientOperator
{
    static constexpr OperatorInfo kInfo{
        .key = "GRADIENT", .label = QT_TRANSLATE_NOOP("Fields", "Gradient"), .followsLine = true};

    [[nodiscard]] static OperatorResult evaluate(const OperatorRequest& request);
};

} // namespace crowd::model
