// SPDX-License-Identifier: MIT
#include "model/gltf/GltfCheckMeshes.h"

namespace crowd::model::gltf {

namespace {

/// The place of an object's member.
std::string memberOf(std::string where, const std::string& name)
{
    return where.append(".").append(name);
}

class MeshCheck
{
public:
    explicit MeshCheck(JsonCheck& check) : m_check(check) {}

    bool run() { return checkAppearance() && checkMeshes(); }

private:
    bool checkAppearance()
    {
        return m_check.each(m_check.root(), "images", "",
                            [this](Json& image, const std::string& where) {
                                return m_check.index(image, "bufferView", "bufferViews", where);
                            }) &&
               m_check.each(m_check.root(), "textures", "",
                            [this](Json& texture, const std::string& where) {
                                return m_check.index(texture, "source", "images", where) &&
                                       m_check.index(texture, "sampler", "samplers", where) &&
                                       checkTextureExtensions(texture, where);
                            }) &&
               m_check.each(m_check.root(), "materials", "",
                            [this](Json& material, const std::string& where) {
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
            if (extension.is_object() && !m_check.index(extension, "source", "images",
                                                        memberOf(where + ".extensions", name))) {
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
            const std::string at = memberOf(where, key);
            if (key.ends_with("Texture") && value.contains("index") &&
                !m_check.index(value, "index", "textures", at, JsonCheck::Need::Required)) {
                return false;
            }
            if (key.ends_with("Texture") && !m_check.whole(value, "texCoord", at, 0, 255)) {
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
        return m_check.each(
            m_check.root(), "meshes", "", [this](Json& mesh, const std::string& where) {
                if (countOf(mesh, "primitives") == 0) {
                    return m_check.fail(where + ".primitives",
                                        QT_TRANSLATE_NOOP("Messages", "%1 is missing or empty"));
                }
                return m_check.each(
                    mesh, "primitives", where + ".",
                    [this](Json& part, const std::string& at) { return checkPrimitive(part, at); });
            });
    }

    bool attributes(Json& owner, const std::string& where)
    {
        for (auto& [name, value] : owner.items()) {
            if (!m_check.indexValue(value, "accessors", memberOf(where, name))) {
                return false;
            }
        }
        return true;
    }

    bool checkPrimitive(Json& primitive, const std::string& where)
    {
        const auto found = primitive.find("attributes");
        if (found == primitive.end() || !found->is_object()) {
            return m_check.fail(where + ".attributes",
                                QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
        }
        if (!attributes(*found, where + ".attributes") ||
            !m_check.index(primitive, "indices", "accessors", where) ||
            !m_check.index(primitive, "material", "materials", where) ||
            !m_check.whole(primitive, "mode", where, 0, 6)) {
            return false;
        }
        return m_check.each(primitive, "targets", where + ".",
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
        const Json& root = member(member(m_check.root(), "extensions"), "KHR_materials_variants");
        const std::size_t variants = countOf(root, "variants");
        Json& extension = primitive["extensions"]["KHR_materials_variants"];
        const std::string at = where + ".extensions.KHR_materials_variants.";
        return m_check.each(
            extension, "mappings", at, [&](Json& mapping, const std::string& inner) {
                if (!m_check.index(mapping, "material", "materials", inner,
                                   JsonCheck::Need::Required)) {
                    return false;
                }
                const Json& list = member(mapping, "variants");
                for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
                    if (asWhole(list[i]).value_or(variants) >= variants) {
                        return m_check.fail(
                            inner + "." + place("variants", i),
                            QT_TRANSLATE_NOOP("Messages",
                                              "%1 is not one of the file's %2 variants"),
                            variants);
                    }
                }
                return true;
            });
    }

    JsonCheck& m_check;
};

} // namespace

bool checkMeshes(JsonCheck& check)
{
    return MeshCheck(check).run();
}

} // namespace crowd::model::gltf
