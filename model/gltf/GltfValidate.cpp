// SPDX-License-Identifier: MIT
#include "model/gltf/GltfValidate.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/gltf/GltfLimits.h"

namespace crowd::model::gltf {

namespace {

constexpr std::array<std::string_view, 11> kArrays{
    "accessors", "animations", "bufferViews", "buffers", "images", "materials",
    "meshes",    "nodes",      "samplers",    "scenes",  "skins"};

/// What may be demanded of us. Extensions that only change how a surface shines are fine: the file
/// looks plainer, not wrong.
constexpr std::array<std::string_view, 24> kKnownExtensions{
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
};

/// Collects the first fault; every check returns whether all is well so far.
class Structure
{
public:
    explicit Structure(Json& root) : m_root(root) {}

    Result<void> run()
    {
        if (checkVersion() && checkExtensions() && checkArrays() && checkData() &&
            checkAppearance() && checkMeshes() && checkNodes() && checkSkins() &&
            checkAnimations() && checkScenes() && checkTrees()) {
            return {};
        }
        return Error{m_problem};
    }

private:
    enum class Need { Optional, Required };

    bool fail(const std::string& where, const std::string& what)
    {
        m_problem = where + " " + what;
        return false;
    }

    Json& item(const char* array, std::size_t i) { return m_root[array][i]; }

    /// object[key] is an index into the top-level array `target`.
    bool index(Json& object, const std::string& key, const char* target, const std::string& where,
               Need need = Need::Optional)
    {
        const auto found = object.find(key);
        if (found == object.end()) {
            return need == Need::Optional || fail(where + "." + key, "is missing");
        }
        return indexValue(*found, target, where + "." + key);
    }

    bool indexValue(Json& value, const char* target, const std::string& where)
    {
        const std::optional<std::uint64_t> whole = asWhole(value);
        const std::size_t count = countOf(m_root, target);
        if (!whole) {
            return fail(where, "is not the index of one of the file's " + std::string(target));
        }
        if (*whole >= count) {
            return fail(where, "is " + std::to_string(*whole) + ", but the file has only " +
                                   std::to_string(count) + " " + target);
        }
        value = *whole;
        return true;
    }

    bool indices(Json& object, const char* key, const char* target, const std::string& where,
                 Need need = Need::Optional)
    {
        const auto found = object.find(key);
        if (found == object.end()) {
            return need == Need::Optional || fail(where + "." + key, "is missing");
        }
        if (!found->is_array() || (found->empty() && need == Need::Required)) {
            return fail(where + "." + key, "is not a list of indices");
        }
        for (std::size_t i = 0; i < found->size(); ++i) {
            if (!indexValue((*found)[i], target, where + "." + place(key, i))) {
                return false;
            }
        }
        return true;
    }

    bool whole(Json& object, const char* key, const std::string& where, std::uint64_t low,
               std::uint64_t high, Need need = Need::Optional)
    {
        const auto found = object.find(key);
        if (found == object.end()) {
            return need == Need::Optional || fail(where + "." + key, "is missing");
        }
        const std::optional<std::uint64_t> value = asWhole(*found);
        if (!value || *value < low || *value > high) {
            return fail(where + "." + key, "is " + found->dump().substr(0, 40) +
                                               ", not a whole number from " + std::to_string(low) +
                                               " to " + std::to_string(high));
        }
        *found = *value;
        return true;
    }

    /// Runs check(object, place) over a list of objects within `parent`.
    template<class Check>
    bool each(Json& parent, const char* key, const std::string& prefix, Check check)
    {
        const auto found = parent.find(key);
        if (found == parent.end()) {
            return true;
        }
        if (!found->is_array()) {
            return fail(prefix + key, "is not a list");
        }
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string where = prefix + place(key, i);
            if (!(*found)[i].is_object()) {
                return fail(where, "is not an object");
            }
            if (!check((*found)[i], where)) {
                return false;
            }
        }
        return true;
    }

    bool checkVersion()
    {
        const Json& asset = member(m_root, "asset");
        const std::string minimum = textOf(asset, "minVersion");
        const std::string version = minimum.empty() ? textOf(asset, "version") : minimum;
        if (version.empty()) {
            return fail("asset.version", "is missing, so this is no glTF 2.0 file");
        }
        if (!version.starts_with("2.") || (!minimum.empty() && minimum != "2.0")) {
            return fail("asset.version",
                        "asks for glTF " + version.substr(0, 20) + "; only glTF 2.0 can be read");
        }
        return true;
    }

    bool checkExtensions()
    {
        const Json& required = member(m_root, "extensionsRequired");
        for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
            const std::string where = place("extensionsRequired", i);
            if (!required[i].is_string()) {
                return fail(where, "is not a name");
            }
            const auto& name = required[i].get_ref<const std::string&>();
            if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) ==
                kKnownExtensions.end()) {
                return fail(where,
                            "demands the extension " + name.substr(0, 80) +
                                ", which Crowdbrush cannot read; export the file without it");
            }
        }
        return true;
    }

    bool checkArrays()
    {
        for (const std::string_view name : kArrays) {
            if (!each(m_root, name.data(), "",
                      [](const Json&, const std::string&) { return true; })) {
                return false;
            }
        }
        if (countOf(m_root, "nodes") > kMaxNodes) {
            return fail("nodes", "are more than " + std::to_string(kMaxNodes));
        }
        return each(m_root, "textures", "", [](const Json&, const std::string&) { return true; });
    }

    bool checkData()
    {
        return each(m_root, "buffers", "",
                    [this](Json& buffer, const std::string& where) {
                        return whole(buffer, "byteLength", where, 0, kMaxBufferBytes,
                                     Need::Required);
                    }) &&
               each(m_root, "bufferViews", "",
                    [this](Json& view, const std::string& where) {
                        return index(view, "buffer", "buffers", where, Need::Required) &&
                               whole(view, "byteOffset", where, 0, kMaxBufferBytes) &&
                               whole(view, "byteLength", where, 0, kMaxBufferBytes,
                                     Need::Required) &&
                               whole(view, "byteStride", where, 0, 252);
                    }) &&
               each(m_root, "accessors", "", [this](Json& accessor, const std::string& where) {
                   return checkAccessor(accessor, where);
               });
    }

    bool checkAccessor(Json& accessor, const std::string& where)
    {
        if (!index(accessor, "bufferView", "bufferViews", where) ||
            !whole(accessor, "byteOffset", where, 0, kMaxBufferBytes) ||
            !whole(accessor, "count", where, 0, kMaxAccessorElements, Need::Required) ||
            !whole(accessor, "componentType", where, 5120, 5126, Need::Required)) {
            return false;
        }
        if (componentBytes(wholeOr(accessor, "componentType", 0)) == 0) {
            return fail(where + ".componentType", "is none that glTF 2.0 knows");
        }
        if (componentCount(textOf(accessor, "type")) == 0) {
            return fail(where + ".type", "is none that glTF 2.0 knows");
        }
        const auto sparse = accessor.find("sparse");
        return sparse == accessor.end() || checkSparse(accessor, *sparse, where + ".sparse");
    }

    bool checkSparse(const Json& accessor, Json& sparse, const std::string& where)
    {
        if (!sparse.is_object() || !member(sparse, "indices").is_object() ||
            !member(sparse, "values").is_object()) {
            return fail(where, "lacks its indices or values");
        }
        Json& indexPart = sparse["indices"];
        Json& valuePart = sparse["values"];
        if (!whole(sparse, "count", where, 0, wholeOr(accessor, "count", 0), Need::Required) ||
            !index(indexPart, "bufferView", "bufferViews", where + ".indices", Need::Required) ||
            !whole(indexPart, "byteOffset", where + ".indices", 0, kMaxBufferBytes) ||
            !whole(indexPart, "componentType", where + ".indices", 5121, 5125, Need::Required) ||
            !index(valuePart, "bufferView", "bufferViews", where + ".values", Need::Required) ||
            !whole(valuePart, "byteOffset", where + ".values", 0, kMaxBufferBytes)) {
            return false;
        }
        const std::uint64_t type = wholeOr(indexPart, "componentType", 0);
        return type == 5121 || type == 5123 || type == 5125 ||
               fail(where + ".indices.componentType", "is not an unsigned type");
    }

    bool checkAppearance()
    {
        return each(m_root, "images", "",
                    [this](Json& image, const std::string& where) {
                        return index(image, "bufferView", "bufferViews", where);
                    }) &&
               each(m_root, "textures", "",
                    [this](Json& texture, const std::string& where) {
                        return index(texture, "source", "images", where) &&
                               index(texture, "sampler", "samplers", where) &&
                               checkTextureExtensions(texture, where);
                    }) &&
               each(m_root, "materials", "", [this](Json& material, const std::string& where) {
                   return checkTextureInfos(material, where, 0);
               });
    }

    bool checkTextureExtensions(Json& texture, const std::string& where)
    {
        const auto extensions = texture.find("extensions");
        if (extensions == texture.end() || !extensions->is_object()) {
            return true;
        }
        for (auto& [name, extension] : extensions->items()) {
            if (extension.is_object() &&
                !index(extension, "source", "images", where + ".extensions." + name)) {
                return false;
            }
        }
        return true;
    }

    /// Every "…Texture" object anywhere in a material, extensions included, holds a texture index.
    bool checkTextureInfos(Json& object, const std::string& where, int depth)
    {
        for (auto& [key, value] : object.items()) {
            if (key == "extras" || !value.is_object() || depth > 4) {
                continue;
            }
            const std::string at = where + "." + key;
            if (key.ends_with("Texture") && value.contains("index") &&
                !index(value, "index", "textures", at, Need::Required)) {
                return false;
            }
            if (key.ends_with("Texture") && !whole(value, "texCoord", at, 0, 255)) {
                return false;
            }
            if (!checkTextureInfos(value, at, depth + 1)) {
                return false;
            }
        }
        return true;
    }

    bool checkMeshes()
    {
        return each(m_root, "meshes", "", [this](Json& mesh, const std::string& where) {
            if (countOf(mesh, "primitives") == 0) {
                return fail(where + ".primitives", "is missing or empty");
            }
            return each(mesh, "primitives", where + ".", [this](Json& part, const std::string& at) {
                return checkPrimitive(part, at);
            });
        });
    }

    bool attributes(Json& owner, const std::string& where)
    {
        for (auto& [name, value] : owner.items()) {
            if (!indexValue(value, "accessors", where + "." + name)) {
                return false;
            }
        }
        return true;
    }

    bool checkPrimitive(Json& primitive, const std::string& where)
    {
        const auto found = primitive.find("attributes");
        if (found == primitive.end() || !found->is_object()) {
            return fail(where + ".attributes", "is missing");
        }
        if (!attributes(*found, where + ".attributes") ||
            !index(primitive, "indices", "accessors", where) ||
            !index(primitive, "material", "materials", where) ||
            !whole(primitive, "mode", where, 0, 6)) {
            return false;
        }
        return each(primitive, "targets", where + ".",
                    [this](Json& target, const std::string& at) {
                        return attributes(target, at);
                    }) &&
               checkVariants(primitive, where);
    }

    bool checkVariants(Json& primitive, const std::string& where)
    {
        const Json& present = member(member(primitive, "extensions"), "KHR_materials_variants");
        if (!present.is_object()) {
            return true;
        }
        const Json& root = member(member(m_root, "extensions"), "KHR_materials_variants");
        const std::size_t variants = countOf(root, "variants");
        Json& extension = primitive["extensions"]["KHR_materials_variants"];
        const std::string at = where + ".extensions.KHR_materials_variants.";
        return each(extension, "mappings", at, [&](Json& mapping, const std::string& inner) {
            if (!index(mapping, "material", "materials", inner, Need::Required)) {
                return false;
            }
            const Json& list = member(mapping, "variants");
            for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
                if (asWhole(list[i]).value_or(variants) >= variants) {
                    return fail(inner + "." + place("variants", i), "is not one of the file's " +
                                                                        std::to_string(variants) +
                                                                        " variants");
                }
            }
            return true;
        });
    }

    bool numbers(const Json& object, const char* key, std::size_t count, const std::string& where)
    {
        const Json& list = member(object, key);
        if (list.is_null()) {
            return true;
        }
        const bool isFine = list.is_array() && list.size() == count &&
                            std::all_of(list.begin(), list.end(),
                                        [](const Json& value) { return value.is_number(); });
        return isFine ||
               fail(where + "." + key, "is not a list of " + std::to_string(count) + " numbers");
    }

    bool checkNodes()
    {
        return each(m_root, "nodes", "", [this](Json& node, const std::string& where) {
            return indices(node, "children", "nodes", where) &&
                   index(node, "mesh", "meshes", where) && index(node, "skin", "skins", where) &&
                   numbers(node, "matrix", 16, where) && numbers(node, "translation", 3, where) &&
                   numbers(node, "rotation", 4, where) && numbers(node, "scale", 3, where) &&
                   checkLods(node, where);
        });
    }

    bool checkLods(Json& node, const std::string& where)
    {
        if (!member(member(node, "extensions"), "MSFT_lod").is_object()) {
            return true;
        }
        return indices(node["extensions"]["MSFT_lod"], "ids", "nodes",
                       where + ".extensions.MSFT_lod");
    }

    bool checkSkins()
    {
        return each(m_root, "skins", "", [this](Json& skin, const std::string& where) {
            if (!indices(skin, "joints", "nodes", where, Need::Required) ||
                !index(skin, "inverseBindMatrices", "accessors", where)) {
                return false;
            }
            if (!skin.contains("inverseBindMatrices")) {
                return true;
            }
            const Json& accessor = item("accessors", wholeOr(skin, "inverseBindMatrices", 0));
            if (textOf(accessor, "type") != "MAT4" ||
                wholeOr(accessor, "componentType", 0) != 5126 ||
                wholeOr(accessor, "count", 0) < countOf(skin, "joints")) {
                return fail(where + ".inverseBindMatrices",
                            "is not a list of one 4x4 matrix a joint");
            }
            return true;
        });
    }

    bool checkAnimations()
    {
        return each(m_root, "animations", "", [this](Json& clip, const std::string& where) {
            const std::size_t samplers = countOf(clip, "samplers");
            return each(clip, "samplers", where + ".",
                        [this](Json& sampler, const std::string& at) {
                            return index(sampler, "input", "accessors", at, Need::Required) &&
                                   index(sampler, "output", "accessors", at, Need::Required);
                        }) &&
                   each(clip, "channels", where + ".", [&](Json& channel, const std::string& at) {
                       return checkChannel(channel, samplers, at);
                   });
        });
    }

    bool checkChannel(Json& channel, std::size_t samplers, const std::string& where)
    {
        if (wholeOr(channel, "sampler", samplers) >= samplers) {
            return fail(where + ".sampler",
                        "is not one of the animation's " + std::to_string(samplers) + " samplers");
        }
        const auto target = channel.find("target");
        if (target == channel.end() || !target->is_object()) {
            return fail(where + ".target", "is missing");
        }
        return index(*target, "node", "nodes", where + ".target");
    }

    bool checkScenes()
    {
        if (m_root.contains("scene") && countOf(m_root, "scenes") == 0) {
            return fail("scene", "names a scene, but the file has none");
        }
        return index(m_root, "scene", "scenes", "file") &&
               each(m_root, "scenes", "", [this](Json& scene, const std::string& where) {
                   return indices(scene, "nodes", "nodes", where);
               });
    }

    /// Each node has at most one parent, and following parents ends at a root.
    bool checkTrees()
    {
        const std::size_t count = countOf(m_root, "nodes");
        std::vector<std::size_t> parent(count, count);
        for (std::size_t i = 0; i < count; ++i) {
            const Json& children = member(item("nodes", i), "children");
            for (std::size_t c = 0; children.is_array() && c < children.size(); ++c) {
                const auto child = children[c].get<std::size_t>();
                if (parent[child] != count && parent[child] != i) {
                    return fail(place("nodes", child), "is a child of both " +
                                                           place("nodes", parent[child]) + " and " +
                                                           place("nodes", i));
                }
                parent[child] = i;
            }
        }
        return checkCycles(parent);
    }

    bool checkCycles(const std::vector<std::size_t>& parent)
    {
        const std::size_t count = parent.size();
        std::vector<std::size_t> seenFrom(count, count);
        for (std::size_t start = 0; start < count; ++start) {
            for (std::size_t at = start; at != count && seenFrom[at] == count; at = parent[at]) {
                seenFrom[at] = start;
                if (parent[at] != count && seenFrom[parent[at]] == start) {
                    return fail(place("nodes", at), "is its own ancestor");
                }
            }
        }
        return true;
    }

    Json& m_root;
    std::string m_problem;
};

/// Whether [offset, offset + length) lies within `available`, without overflow.
bool fits(std::uint64_t offset, std::uint64_t length, std::uint64_t available)
{
    return offset <= available && length <= available - offset;
}

Error pastEnd(const std::string& where, std::uint64_t end, const std::string& what,
              std::uint64_t available)
{
    return Error{where + " reaches to byte " + std::to_string(end) + ", but " + what +
                 " has only " + std::to_string(available)};
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
        const Result<void> run =
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
    const Result<void> indexRun = checkRun(
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
    return Structure(root).run();
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
        const Result<void> layout = checkAccessorLayout(root, i);
        if (!layout) {
            return layout;
        }
    }
    return {};
}

} // namespace crowd::model::gltf
