// SPDX-License-Identifier: MIT
#include "model/states/StateDifference.h"

#include <algorithm>
#include <cstring>

#include "model/states/StateKeeping.h"

namespace crowd::model {

StateDifference differenceFrom(const State& state, const Scene& scene, const ColumnSet& without)
{
    Scene recalled = scene;
    StateDifference difference;
    ColumnSet compared;
    state.columns.forEach([&](ColumnId column) {
        if (!without.contains(column)) {
            compared.insert(column);
        }
    });
    difference.ids = recallState(recalled, state, compared, nullptr).changed;
    for (const PropertyAspectInfo& aspect : propertyAspects()) {
        std::vector<bool> differs(scene.population.size());
        columnsOf(aspect.aspect).forEach([&](ColumnId column) {
            const auto before = scene.population.columnBytes(column);
            const auto after = recalled.population.columnBytes(column);
            if (before.data() == after.data()) {
                return; // shared: nobody differs
            }
            const std::size_t stride = columnInfo(column).stride;
            for (std::size_t row = 0; row < differs.size(); ++row) {
                const std::size_t at = row * stride;
                if (std::memcmp(before.data() + at, after.data() + at, stride) != 0) {
                    differs[row] = true;
                }
            }
        });
        const auto people = static_cast<std::size_t>(std::ranges::count(differs, true));
        if (people > 0) {
            difference.aspects.push_back({aspect.aspect, people});
        }
    }
    return difference;
}

} // namespace crowd::model
