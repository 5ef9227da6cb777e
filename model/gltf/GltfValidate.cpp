// SPDX-License-Identifier: MIT
#include "model/gltf/GltfValidate.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/gltf/GltfCheckData.h"
#include "model/gltf/GltfCheckMeshes.h"
#include "model/gltf/GltfCheckScenes.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

namespace {

constexpr std::array<const char*, 12> kArrays{"accessors", "animations", "bufferViews", "buffers",
                                              "images",    "materials",  "meshes",      "nodes",
                                              "samplers",  "scenes",     "skins",       "textures"};

/// What may be demanded of us. Extensions that only change how a surface shines, or hold pictures
/// that we cannot decode, are fine: the file looks plainer, not wrong.
constexpr std::array<std::string_view, 17> kKnownExtensions{
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
    "MSFT_texture_dds",
};

bool isKnown(const std::string& extension)
{
    return extension.starts_with("KHR_materials_") ||
           std::find(kKnownExtensions.begin(), kKnownExtensions.end(), extension) !=
               kKnownExtensions.end();
}

bool checkVersion(JsonCheck& check)
{
    const Json& asset = member(check.root(), "asset");
    const std::string minimum = textOf(asset, "minVersion");
    const std::string version = minimum.empty() ? textOf(asset, "version") : minimum;
    if (version.empty()) {
        return check.fail(
            "asset.version",
            QT_TRANSLATE_NOOP("Messages", "%1 is missing, so this is no glTF 2.0 file"));
    }
    if (!version.starts_with("2.") || (!minimum.empty() && minimum != "2.0")) {
        return check.fail(
            "asset.version",
            QT_TRANSLATE_NOOP("Messages", "%1 asks for glTF %2; only glTF 2.0 can be read"),
            shortened(version, 20));
    }
    return true;
}

bool checkExtensions(JsonCheck& check)
{
    const Json& required = member(check.root(), "extensionsRequired");
    for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
        const std::string where = place("extensionsRequired", i);
        if (!required[i].is_string()) {
            return check.fail(where, QT_TRANSLATE_NOOP("Messages", "%1 is not a name"));
        }
        const auto& name = required[i].get_ref<const std::string&>();
        if (!isKnown(name)) {
            return check.fail(where,
                              QT_TRANSLATE_NOOP("Messages",
                                                "%1 demands the extension %2, which Crowdbrush "
                                                "cannot read; export the file without it"),
                              shortened(name, 80));
        }
    }
    return true;
}

bool checkArrays(JsonCheck& check)
{
    for (const char* name : kArrays) {
        if (countOf(check.root(), name) > kMaxItems) {
            return check.fail(name, QT_TRANSLATE_NOOP("Messages", "%1 are more than %2"),
                              kMaxItems);
        }
        if (!check.each(check.root(), name, "",
                        [](const Json&, const std::string&) { return true; })) {
            return false;
        }
    }
    return true;
}

/// Whether [offset, offset + length) lies within `available`, without overflow.
bool fits(std::uint64_t offset, std::uint64_t length, std::uint64_t available)
{
    return offset <= available && length <= available - offset;
}

Error pastEnd(const std::string& where, std::uint64_t end, const std::string& what,
              std::uint64_t available)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1 reaches to byte %2, but %3 has only %4"), where,
                 end, what, available};
}

/// `count` elements at `offset` within a view, `stride` apart.
Result<void> checkRun(const Json& root, std::uint64_t view, std::uint64_t offset,
                      std::uint64_t count, std::uint64_t element, bool usesStride,
                      const std::string& where)
{
    if (count == 0) {
        return {};
    }
    const Json& bufferView = root.at("bufferViews").at(view);
    const std::uint64_t stride = usesStride ? wholeOr(bufferView, "byteStride", 0) : 0;
    const std::uint64_t available = wholeOr(bufferView, "byteLength", 0);
    // All factors are bounded (count < 2^26, stride < 2^8), so this cannot overflow.
    const std::uint64_t length = (count - 1) * (stride == 0 ? element : stride) + element;
    if (!fits(offset, length, available)) {
        return pastEnd(where, offset + length, place("bufferViews", view), available);
    }
    return {};
}

Result<void> checkAccessorLayout(const Json& root, std::size_t i)
{
    const Json& accessor = root.at("accessors").at(i);
    const std::string where = place("accessors", i);
    const std::size_t element =
        elementBytes(wholeOr(accessor, "componentType", 0), textOf(accessor, "type"));
    if (accessor.contains("bufferView")) {
        Result<void> run =
            checkRun(root, wholeOr(accessor, "bufferView", 0), wholeOr(accessor, "byteOffset", 0),
                     wholeOr(accessor, "count", 0), element, true, where);
        if (!run) {
            return run;
        }
    }
    const Json& sparse = member(accessor, "sparse");
    if (!sparse.is_object()) {
        return {};
    }
    const std::uint64_t count = wholeOr(sparse, "count", 0);
    const Json& indexPart = member(sparse, "indices");
    Result<void> indexRun = checkRun(
        root, wholeOr(indexPart, "bufferView", 0), wholeOr(indexPart, "byteOffset", 0), count,
        componentBytes(wholeOr(indexPart, "componentType", 0)), false, where + ".sparse.indices");
    if (!indexRun) {
        return indexRun;
    }
    const Json& valuePart = member(sparse, "values");
    return checkRun(root, wholeOr(valuePart, "bufferView", 0), wholeOr(valuePart, "byteOffset", 0),
                    count, element, false, where + ".sparse.values");
}

} // namespace

std::size_t componentBytes(std::uint64_t componentType)
{
    switch (componentType) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    case 5125:
    case 5126:
        return 4;
    default:
        return 0;
    }
}

std::size_t componentCount(const std::string& type)
{
    constexpr std::array<std::pair<std::string_view, std::size_t>, 7> kTypes{{{"SCALAR", 1},
                                                                              {"VEC2", 2},
                                                                              {"VEC3", 3},
                                                                              {"VEC4", 4},
                                                                              {"MAT2", 4},
                                                                              {"MAT3", 9},
                                                                              {"MAT4", 16}}};
    for (const auto& [name, count] : kTypes) {
        if (type == name) {
            return count;
        }
    }
    return 0;
}

std::size_t elementBytes(std::uint64_t componentType, const std::string& type)
{
    const std::size_t size = componentBytes(componentType);
    if (!type.starts_with("MAT")) {
        return size * componentCount(type);
    }
    const std::size_t rows = type == "MAT2" ? 2 : type == "MAT3" ? 3 : 4;
    return rows * ((rows * size + 3) / 4 * 4);
}

Result<void> validateStructure(Json& root)
{
    JsonCheck check(root);
    if (checkVersion(check) && checkExtensions(check) && checkArrays(check) && checkData(check) &&
        checkMeshes(check) && checkScenes(check)) {
        return {};
    }
    return Error{check.problem()};
}

Result<void> validateLayout(const Json& root, const std::vector<std::size_t>& bufferBytes)
{
    for (std::size_t i = 0; i < countOf(root, "bufferViews"); ++i) {
        const Json& view = root.at("bufferViews").at(i);
        const std::uint64_t buffer = wholeOr(view, "buffer", 0);
        const std::uint64_t offset = wholeOr(view, "byteOffset", 0);
        const std::uint64_t length = wholeOr(view, "byteLength", 0);
        if (!fits(offset, length, bufferBytes[buffer])) {
            return pastEnd(place("bufferViews", i), offset + length, place("buffers", buffer),
                           bufferBytes[buffer]);
        }
    }
    for (std::size_t i = 0; i < countOf(root, "accessors"); ++i) {
        Result<void> layout = checkAccessorLayout(root, i);
        if (!layout) {
            return layout;
        }
    }
    return {};
}

} // namespace crowd::model::gltf
