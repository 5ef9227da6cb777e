// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/population/Properties.h"
#include "model/scene/Scene.h"

/// In what people differ from how a state has them.
namespace crowd::model {

struct StateDifference
{
    struct Aspect
    {
        PropertyAspect aspect{};
        std::size_t people = 0; ///< who differ in one of its properties
    };
    std::vector<Aspect> aspects;   ///< in their order; those in which somebody differs
    std::vector<IndividualId> ids; ///< who differ at all, ascending
};

/// What recalling the state would change of a scene, in properties that it holds, but for those
/// `without`.
[[nodiscard]] StateDifference differenceFrom(const State& state, const Scene& scene,
                                             const ColumnSet& without = {});

} // namespace crowd::model
