// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

namespace crowd::model {

/// Calls work(stride) with a constant for the widths that columns have: copies and comparisons of a
/// known width are single instructions.
template<class Work>
void withStride(std::size_t stride, const Work& work)
{
    switch (stride) {
    case 1:
        return work(std::integral_constant<std::size_t, 1>());
    case 2:
        return work(std::integral_constant<std::size_t, 2>());
    case 4:
        return work(std::integral_constant<std::size_t, 4>());
    case 8:
        return work(std::integral_constant<std::size_t, 8>());
    case 12:
        return work(std::integral_constant<std::size_t, 12>());
    default:
        return work(stride);
    }
}

} // namespace crowd::model
