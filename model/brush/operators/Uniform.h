// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/operators/OperatorRequest.h"

namespace crowd::model {

/// The lowest value for everybody.
struct UniformOperator
{
    static constexpr OperatorInfo kInfo{.key = "UNIFORM",
                                        .label = QT_TRANSLATE_NOOP("Fields", "Uniform")};

    [[nodiscard]] static OperatorResult evaluate(const OperatorRequest& request)
    {
        return {std::vector<double>(request.ids.size(), 0.0)};
    }
};

} // namespace crowd::model
