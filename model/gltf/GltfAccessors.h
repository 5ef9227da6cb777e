// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace tinygltf {
class Model;
}

/// Decoding of checked accessors: all component types, normalised integers, strides, sparse values,
/// zeros where there is no view (glTF 2.0, section 3.6.2).
namespace crowd::model::gltf {

/// Numbers of an accessor: count × components, matrices by columns.
struct FloatArray
{
    std::size_t count = 0;
    std::size_t components = 0;
    std::vector<float> values;

    [[nodiscard]] const float* at(std::size_t i) const { return values.data() + i * components; }
};

/// `accessor` is a valid index. Integers become fractions where the accessor says so. Of longer
/// ones only the first `limit` elements are read.
[[nodiscard]] FloatArray readFloats(const tinygltf::Model& model, int accessor,
                                    std::size_t limit = ~std::size_t{0});

/// The first component of each element as whole numbers; negative ones and fractions become 0.
[[nodiscard]] std::vector<std::uint32_t> readScalars(const tinygltf::Model& model, int accessor);

/// All components as whole numbers.
[[nodiscard]] std::vector<std::uint32_t> readWholes(const tinygltf::Model& model, int accessor);

/// Replaces numbers that are not finite by 0; how many there were.
std::size_t replaceNonFinite(std::vector<float>& values);

} // namespace crowd::model::gltf
