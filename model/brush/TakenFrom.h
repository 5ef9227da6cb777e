// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "model/scene/Scene.h"

namespace crowd::model {

/// Whom a dropper takes something from.
struct TakenFrom
{
    const Scene& scene;
    const TemplateEntry& entry; ///< whose asset is loaded
    IndividualId id;
    std::size_t row;

    template<class T>
    [[nodiscard]] T value(ColumnKey<T> key) const
    {
        return scene.population.column(key)[row];
    }
};

} // namespace crowd::model
