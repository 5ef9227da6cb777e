// SPDX-License-Identifier: MIT
#include "model/gltf/GltfInstances.h"

#include <algorithm>
#include <string>

#include "model/gltf/GltfAccessors.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

constexpr const char* kInstancingName = "EXT_mesh_gpu_instancing";

/// One of TRANSLATION, ROTATION and SCALE; without values where the file leaves it out.
struct Placement
{
    const char* attribute;
    std::size_t components;
    FloatArray values;

    [[nodiscard]] std::vector<double> at(std::size_t instance) const
    {
        if (values.count == 0) {
            return {};
        }
        const float* from = values.at(instance);
        return {from, from + components};
    }
};

class Expander
{
public:
    explicit Expander(tinygltf::Model& model) : m_model(model) {}

    Result<void> run()
    {
        const std::size_t count = m_model.nodes.size();
        for (std::size_t i = 0; i < count; ++i) {
            const tinygltf::Value* extension = find(m_model.nodes[i].extensions, kInstancingName);
            const bool isDrawn = m_model.nodes[i].mesh >= 0 && m_model.nodes[i].skin < 0;
            if (extension == nullptr || !isDrawn) {
                continue;
            }
            const tinygltf::Value* attributes = find(*extension, "attributes");
            if (attributes != nullptr && !expand(i, *attributes)) {
                return Error{m_problem};
            }
        }
        return {};
    }

private:
    /// A message whose %1 is the place: the node, or one of its attributes.
    template<class... Arguments>
    bool fail(const std::string& where, const char* id, const Arguments&... arguments)
    {
        m_problem = Message(id, where, arguments...);
        return false;
    }

    bool read(const tinygltf::Value& attributes, const std::string& extension, Placement& placement,
              std::size_t& instances)
    {
        if (find(attributes, placement.attribute) == nullptr) {
            return true;
        }
        const int index = wholeIn(attributes, placement.attribute, -1);
        const std::string where = extension + ".attributes." + placement.attribute;
        if (index < 0 || static_cast<std::size_t>(index) >= m_model.accessors.size()) {
            return fail(
                where, QT_TRANSLATE_NOOP("Messages", "%1 is not the index of one of the file's %2"),
                "accessors");
        }
        const tinygltf::Accessor& accessor = m_model.accessors[static_cast<std::size_t>(index)];
        const int type = placement.components == 4 ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
        if (accessor.type != type || (instances != kUnknown && accessor.count != instances)) {
            return fail(where,
                        QT_TRANSLATE_NOOP("Messages",
                                          "%1 has another type or count than its fellows need"));
        }
        instances = accessor.count;
        if (instances > kMaxItems) {
            return fail(extension, QT_TRANSLATE_NOOP("Messages", "%1: more than %2 instances"),
                        kMaxItems);
        }
        placement.values = readFloats(m_model, index);
        return true;
    }

    bool expand(std::size_t node, const tinygltf::Value& attributes)
    {
        Placement translation{"TRANSLATION", 3, {}};
        Placement rotation{"ROTATION", 4, {}};
        Placement scale{"SCALE", 3, {}};
        std::size_t instances = kUnknown;
        const std::string extension = place("nodes", node) + ".extensions." + kInstancingName;
        if (!read(attributes, extension, translation, instances) ||
            !read(attributes, extension, rotation, instances) ||
            !read(attributes, extension, scale, instances)) {
            return false;
        }
        if (instances == kUnknown) {
            return true;
        }
        if (m_model.nodes.size() + instances > 2 * kMaxItems) {
            return fail(extension, QT_TRANSLATE_NOOP("Messages", "%1: more than %2 instances"),
                        kMaxItems);
        }
        tinygltf::Node child;
        child.name = m_model.nodes[node].name;
        child.mesh = m_model.nodes[node].mesh;
        m_model.nodes[node].mesh = -1;
        for (std::size_t i = 0; i < instances; ++i) {
            child.translation = translation.at(i);
            child.rotation = rotation.at(i);
            child.scale = scale.at(i);
            m_model.nodes[node].children.push_back(static_cast<int>(m_model.nodes.size()));
            m_model.nodes.push_back(child);
        }
        return true;
    }

    static constexpr std::size_t kUnknown = ~std::size_t{0};

    tinygltf::Model& m_model;
    Message m_problem;
};

} // namespace

Result<void> expandInstances(tinygltf::Model& model)
{
    return Expander(model).run();
}

} // namespace crowd::model::gltf
