// SPDX-License-Identifier: MIT
#include "model/gltf/GltfAccessors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <tiny_gltf.h>

#include "model/gltf/GltfValidate.h"

namespace crowd::model::gltf {

namespace {

template<class T>
T load(const std::uint8_t* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

double component(const std::uint8_t* bytes, int type)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return load<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return load<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(bytes);
    default:
        return static_cast<double>(load<float>(bytes));
    }
}

/// Divisor of normalised integers; 0 for what is not normalised.
double divisor(const tinygltf::Accessor& accessor)
{
    if (!accessor.normalized) {
        return 0.0;
    }
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return 127.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return 32767.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 65535.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return 4294967295.0;
    default:
        return 0.0;
    }
}

/// Where the components of one element lie: columns of matrices begin at multiples of four bytes.
struct Layout
{
    std::size_t components = 0;
    std::size_t element = 0;
    std::array<std::size_t, 16> offsets{};
};

Layout layoutOf(const tinygltf::Accessor& accessor)
{
    constexpr std::array kNames{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    constexpr std::array kTypes{TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3,
                                TINYGLTF_TYPE_VEC4,   TINYGLTF_TYPE_MAT2, TINYGLTF_TYPE_MAT3,
                                TINYGLTF_TYPE_MAT4};
    const auto found = std::find(kTypes.begin(), kTypes.end(), accessor.type);
    const std::string name = kNames[static_cast<std::size_t>(found - kTypes.begin())];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    const std::size_t size = componentBytes(type);
    Layout layout;
    layout.components = componentCount(name);
    layout.element = elementBytes(type, name);
    const std::size_t rows = name == "MAT2" ? 2 : name == "MAT3" ? 3 : 4;
    const std::size_t column = name.starts_with("MAT") ? layout.element / rows : 0;
    for (std::size_t i = 0; i < layout.components; ++i) {
        layout.offsets[i] = column == 0 ? i * size : i / rows * column + i % rows * size;
    }
    return layout;
}

const std::uint8_t* viewBytes(const tinygltf::Model& model, int view, std::size_t offset)
{
    const tinygltf::BufferView& bufferView = model.bufferViews[static_cast<std::size_t>(view)];
    const auto buffer = static_cast<std::size_t>(bufferView.buffer);
    return model.buffers[buffer].data.data() + bufferView.byteOffset + offset;
}

/// Calls use(element, bytes of it) for the first `count` dense elements, then for the sparse ones
/// over them.
template<class Use>
void forElements(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                 const Layout& layout, std::size_t count, Use use)
{
    if (accessor.bufferView >= 0 && count > 0) {
        const auto& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
        const std::size_t stride = view.byteStride == 0 ? layout.element : view.byteStride;
        const std::uint8_t* bytes = viewBytes(model, accessor.bufferView, accessor.byteOffset);
        for (std::size_t i = 0; i < count; ++i) {
            use(i, bytes + i * stride);
        }
    }
    if (!accessor.sparse.isSparse || accessor.sparse.count <= 0) {
        return;
    }
    const auto& sparse = accessor.sparse;
    const int indexType = sparse.indices.componentType;
    const std::size_t indexSize = componentBytes(static_cast<std::uint64_t>(indexType));
    const std::uint8_t* indices = viewBytes(model, sparse.indices.bufferView,
                                            static_cast<std::size_t>(sparse.indices.byteOffset));
    const std::uint8_t* values = viewBytes(model, sparse.values.bufferView,
                                           static_cast<std::size_t>(sparse.values.byteOffset));
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
        const auto target = static_cast<std::size_t>(component(indices + i * indexSize, indexType));
        if (target < count) {
            use(target, values + i * layout.element);
        }
    }
}

std::uint32_t wholeComponent(const std::uint8_t* bytes, int type)
{
    const double value = component(bytes, type);
    return value >= 0.0 && value <= 4294967295.0 ? static_cast<std::uint32_t>(value) : 0U;
}

} // namespace

FloatArray readFloats(const tinygltf::Model& model, int index, std::size_t limit)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const Layout layout = layoutOf(accessor);
    const double divide = divisor(accessor);
    FloatArray array{std::min(accessor.count, limit), layout.components, {}};
    array.values.assign(array.count * array.components, 0.0F);
    forElements(
        model, accessor, layout, array.count, [&](std::size_t i, const std::uint8_t* bytes) {
            float* out = array.values.data() + i * layout.components;
            for (std::size_t c = 0; c < layout.components; ++c) {
                const double value = component(bytes + layout.offsets[c], accessor.componentType);
                out[c] = static_cast<float>(divide == 0.0 ? value : std::max(value / divide, -1.0));
            }
        });
    return array;
}

std::vector<std::uint32_t> readScalars(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const Layout layout = layoutOf(accessor);
    std::vector<std::uint32_t> values(accessor.count, 0);
    forElements(model, accessor, layout, accessor.count,
                [&](std::size_t i, const std::uint8_t* bytes) {
                    values[i] = wholeComponent(bytes, accessor.componentType);
                });
    return values;
}

std::vector<std::uint32_t> readWholes(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const Layout layout = layoutOf(accessor);
    std::vector<std::uint32_t> values(accessor.count * layout.components, 0);
    forElements(model, accessor, layout, accessor.count,
                [&](std::size_t i, const std::uint8_t* bytes) {
                    for (std::size_t c = 0; c < layout.components; ++c) {
                        values[i * layout.components + c] =
                            wholeComponent(bytes + layout.offsets[c], accessor.componentType);
                    }
                });
    return values;
}

std::size_t replaceNonFinite(std::vector<float>& values)
{
    std::size_t replaced = 0;
    for (float& value : values) {
        if (!std::isfinite(value)) {
            value = 0.0F;
            ++replaced;
        }
    }
    return replaced;
}

} // namespace crowd::model::gltf
