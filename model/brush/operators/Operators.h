// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "model/brush/operators/Gradient.h"
#include "model/brush/operators/Random.h"
#include "model/brush/operators/Uniform.h"
#include "model/describe/Field.h"

/// The one list of operators. New ones come last: their numbers are known to scripts.
#define CROWD_OPERATORS(OPERATOR)                                                                  \
    OPERATOR(Uniform)                                                                              \
    OPERATOR(Random)                                                                               \
    OPERATOR(Gradient)

namespace crowd::model {

#define CROWD_OPERATOR(name) name,
enum class BrushOperator : std::uint8_t { CROWD_OPERATORS(CROWD_OPERATOR) };
#undef CROWD_OPERATOR

struct OperatorType
{
    OperatorInfo info;
    OperatorResult (*evaluate)(const OperatorRequest&);
};

#define CROWD_OPERATOR(name) OperatorType{name##Operator::kInfo, &name##Operator::evaluate},
/// By BrushOperator.
inline constexpr std::array kOperators{CROWD_OPERATORS(CROWD_OPERATOR)};
#undef CROWD_OPERATOR

#define CROWD_OPERATOR(name) FieldChoice{name##Operator::kInfo.key, name##Operator::kInfo.label},
inline constexpr FieldChoice kOperatorChoices[] = {CROWD_OPERATORS(CROWD_OPERATOR)};
#undef CROWD_OPERATOR

[[nodiscard]] constexpr const OperatorInfo& operatorInfo(BrushOperator op)
{
    return kOperators[static_cast<std::size_t>(op)].info;
}

[[nodiscard]] inline OperatorResult evaluate(BrushOperator op, const OperatorRequest& request)
{
    return kOperators[static_cast<std::size_t>(op)].evaluate(request);
}

} // namespace crowd::model
