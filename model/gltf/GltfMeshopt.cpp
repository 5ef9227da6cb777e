// SPDX-License-Identifier: MIT
#include "model/gltf/GltfMeshopt.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <meshoptimizer.h>

#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

namespace {

constexpr std::array<const char*, 2> kNames{"EXT_meshopt_compression", "KHR_meshopt_compression"};

const Json& extensionOf(const Json& object)
{
    const Json& extensions = member(object, "extensions");
    for (const char* name : kNames) {
        if (const Json& found = member(extensions, name); found.is_object()) {
            return found;
        }
    }
    static const Json none;
    return none;
}

/// What a compressed view says of itself.
struct Packed
{
    std::uint64_t buffer = 0;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::string mode;
    std::string filter;
};

/// Refuses modes and filters that we have no decoder for, as they come with later versions.
Result<void> checkKind(const Packed& packed, const std::string& where)
{
    constexpr std::array<std::string_view, 3> kModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
    constexpr std::array<std::string_view, 5> kFilters{"", "NONE", "OCTAHEDRAL", "QUATERNION",
                                                       "EXPONENTIAL"};
    if (!packed.mode.empty() &&
        std::find(kModes.begin(), kModes.end(), packed.mode) == kModes.end()) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1: it asks for the mode \"%2\", which Crowdbrush "
                                       "cannot read; export the file without compression"),
                     where, shortened(packed.mode, 40)};
    }
    if (std::find(kFilters.begin(), kFilters.end(), packed.filter) == kFilters.end()) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1: it asks for the filter \"%2\", which Crowdbrush "
                                       "cannot read; export the file without compression"),
                     where, shortened(packed.filter, 40)};
    }
    return {};
}

/// The limits that the decoders assume; meshoptimizer asserts them.
bool isSound(const Packed& packed, const std::vector<Bytes>& buffers)
{
    if (packed.buffer >= buffers.size() || packed.count > kMaxAccessorElements ||
        packed.offset > buffers[packed.buffer].size() ||
        packed.length > buffers[packed.buffer].size() - packed.offset) {
        return false;
    }
    if (packed.mode != "ATTRIBUTES") {
        const bool isWhole = packed.mode != "TRIANGLES" || packed.count % 3 == 0;
        return (packed.mode == "TRIANGLES" || packed.mode == "INDICES") && isWhole &&
               (packed.stride == 2 || packed.stride == 4);
    }
    const bool isFiltered =
        packed.filter.empty() || packed.filter == "NONE" || packed.filter == "EXPONENTIAL" ||
        (packed.filter == "OCTAHEDRAL" && (packed.stride == 4 || packed.stride == 8)) ||
        (packed.filter == "QUATERNION" && packed.stride == 8);
    return packed.stride % 4 == 0 && packed.stride >= 4 && packed.stride <= 256 && isFiltered;
}

bool decode(const Packed& packed, const Bytes& from, Bytes& out)
{
    const unsigned char* data = from.data() + packed.offset;
    out.resize(packed.count * packed.stride);
    if (packed.count == 0) {
        return true;
    }
    if (packed.mode == "TRIANGLES") {
        return meshopt_decodeIndexBuffer(out.data(), packed.count, packed.stride, data,
                                         packed.length) == 0;
    }
    if (packed.mode == "INDICES") {
        return meshopt_decodeIndexSequence(out.data(), packed.count, packed.stride, data,
                                           packed.length) == 0;
    }
    if (meshopt_decodeVertexBuffer(out.data(), packed.count, packed.stride, data, packed.length) !=
        0) {
        return false;
    }
    if (packed.filter == "OCTAHEDRAL") {
        meshopt_decodeFilterOct(out.data(), packed.count, packed.stride);
    } else if (packed.filter == "QUATERNION") {
        meshopt_decodeFilterQuat(out.data(), packed.count, packed.stride);
    } else if (packed.filter == "EXPONENTIAL") {
        meshopt_decodeFilterExp(out.data(), packed.count, packed.stride);
    }
    return true;
}

} // namespace

bool isFallback(const Json& buffer)
{
    const Json& fallback = member(extensionOf(buffer), "fallback");
    return fallback.is_boolean() && fallback.get<bool>();
}

Result<void> decodeMeshopt(Json& root, std::vector<Bytes>& buffers)
{
    constexpr std::uint64_t kMissing = ~std::uint64_t{0};
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < countOf(root, "bufferViews"); ++i) {
        Json& view = root["bufferViews"][i];
        const Json& extension = extensionOf(view);
        if (!extension.is_object()) {
            continue;
        }
        const Packed packed{wholeOr(extension, "buffer", kMissing),
                            wholeOr(extension, "byteOffset", 0),
                            wholeOr(extension, "byteLength", kMissing),
                            wholeOr(extension, "byteStride", 0),
                            wholeOr(extension, "count", kMissing),
                            textOf(extension, "mode"),
                            textOf(extension, "filter")};
        const std::string where = place("bufferViews", i) + ".extensions.EXT_meshopt_compression";
        if (const Result<void> known = checkKind(packed, where); !known) {
            return known;
        }
        if (!isSound(packed, buffers)) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1 does not describe data of the file"),
                         where};
        }
        total += packed.count * packed.stride;
        if (total > kMaxBufferBytes) {
            return Error{QT_TRANSLATE_NOOP("Messages",
                                           "%1: the file is larger than 1 GiB when it is unpacked"),
                         where};
        }
        Bytes bytes;
        if (!decode(packed, buffers[packed.buffer], bytes)) {
            return Error{QT_TRANSLATE_NOOP("Messages",
                                           "%1: its compressed data is damaged, or newer than "
                                           "Crowdbrush; export the file without compression"),
                         where};
        }
        view["buffer"] = buffers.size();
        view["byteOffset"] = 0;
        view["byteLength"] = bytes.size();
        view.erase("extensions");
        buffers.push_back(std::move(bytes));
    }
    return {};
}

} // namespace crowd::model::gltf
