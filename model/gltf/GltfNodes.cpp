// SPDX-License-Identifier: MIT
#include "model/gltf/GltfNodes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/gtc/type_ptr.hpp>

#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

std::vector<int> parentsOf(const tinygltf::Model& model)
{
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
        }
    }
    return parents;
}

bool isFinite(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(),
                       [](double v) { return std::isfinite(static_cast<float>(v)); });
}

glm::vec3 vectorOr(const std::vector<double>& values, const glm::vec3& fallback)
{
    return values.size() == 3 && isFinite(values) ? glm::vec3(values[0], values[1], values[2])
                                                  : fallback;
}

Node convertNode(const tinygltf::Node& from, int parent)
{
    Node node;
    node.name = from.name;
    node.parent = parent;
    if (from.matrix.size() == 16 && isFinite(from.matrix)) {
        node.matrix = glm::mat4(glm::make_mat4(from.matrix.data()));
        return node;
    }
    node.translation = vectorOr(from.translation, glm::vec3(0.0F));
    node.scale = vectorOr(from.scale, glm::vec3(1.0F));
    if (from.rotation.size() == 4 && isFinite(from.rotation)) {
        const glm::dquat turn(from.rotation[3], from.rotation[0], from.rotation[1],
                              from.rotation[2]);
        if (glm::length(turn) > 0.0) {
            node.rotation = glm::quat(glm::normalize(turn));
        }
    }
    return node;
}

/// Walks the file's trees without recursion, however deep they are.
class Collector
{
public:
    explicit Collector(const tinygltf::Model& model) : m_model(model), m_parents(parentsOf(model))
    {
        m_scene.ofFileNode.assign(model.nodes.size(), -1);
    }

    SceneNodes run()
    {
        for (const int root : sceneRoots()) {
            addTree(root, -1, true);
        }
        addJointsOutside();
        for (Node& node : m_scene.nodes) {
            const glm::mat4 local = restLocal(node);
            m_scene.restWorld.push_back(
                node.parent < 0 ? local
                                : m_scene.restWorld[static_cast<std::size_t>(node.parent)] * local);
        }
        return std::move(m_scene);
    }

private:
    std::vector<int> sceneRoots() const
    {
        if (!m_model.scenes.empty()) {
            const int scene = std::max(m_model.defaultScene, 0);
            return m_model.scenes[static_cast<std::size_t>(scene)].nodes;
        }
        std::vector<int> roots;
        for (std::size_t i = 0; i < m_parents.size(); ++i) {
            if (m_parents[i] < 0) {
                roots.push_back(static_cast<int>(i));
            }
        }
        return roots;
    }

    struct Pending
    {
        int node;
        int parent;
    };

    void addTree(int root, int parent, bool isDrawn)
    {
        std::vector<Pending> stack{{root, parent}};
        while (!stack.empty()) {
            const Pending next = stack.back();
            stack.pop_back();
            int& here = m_scene.ofFileNode[static_cast<std::size_t>(next.node)];
            if (here >= 0) {
                continue;
            }
            here = static_cast<int>(m_scene.nodes.size());
            const tinygltf::Node& node = m_model.nodes[static_cast<std::size_t>(next.node)];
            m_scene.nodes.push_back(convertNode(node, next.parent));
            m_scene.fileNode.push_back(next.node);
            m_scene.isDrawn.push_back(isDrawn ? 1 : 0);
            pushAlternatives(node, next.parent, stack);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                stack.push_back({*child, here});
            }
        }
    }

    /// Alternatives that hang nowhere take the place of the node that names them.
    void pushAlternatives(const tinygltf::Node& node, int parent, std::vector<Pending>& stack) const
    {
        for (const int other : alternatives(node)) {
            if (m_parents[static_cast<std::size_t>(other)] < 0) {
                stack.push_back({other, parent});
            }
        }
    }

    void addJointsOutside()
    {
        for (std::size_t i = 0; i < m_scene.fileNode.size(); ++i) {
            const int skin = m_model.nodes[static_cast<std::size_t>(m_scene.fileNode[i])].skin;
            if (skin < 0 || !m_skins.insert(skin).second) {
                continue;
            }
            for (const int joint : m_model.skins[static_cast<std::size_t>(skin)].joints) {
                if (m_scene.ofFileNode[static_cast<std::size_t>(joint)] < 0) {
                    addTree(rootOf(joint), -1, false);
                }
            }
        }
    }

    int rootOf(int node) const
    {
        while (m_parents[static_cast<std::size_t>(node)] >= 0) {
            node = m_parents[static_cast<std::size_t>(node)];
        }
        return node;
    }

    const tinygltf::Model& m_model;
    std::vector<int> m_parents;
    std::set<int> m_skins; ///< whose joints are there
    SceneNodes m_scene;
};

} // namespace

std::vector<int> alternatives(const tinygltf::Node& node)
{
    std::vector<int> nodes;
    const tinygltf::Value* extension = find(node.extensions, "MSFT_lod");
    const tinygltf::Value* ids = extension == nullptr ? nullptr : find(*extension, "ids");
    for (std::size_t i = 0; ids != nullptr && ids->IsArray() && i < ids->ArrayLen(); ++i) {
        nodes.push_back(ids->Get(static_cast<int>(i)).GetNumberAsInt());
    }
    return nodes;
}

glm::mat4 restLocal(const Node& node)
{
    if (node.matrix) {
        return *node.matrix;
    }
    glm::mat4 matrix = glm::mat4_cast(node.rotation);
    matrix[0] *= node.scale.x;
    matrix[1] *= node.scale.y;
    matrix[2] *= node.scale.z;
    matrix[3] = glm::vec4(node.translation, 1.0F);
    return matrix;
}

SceneNodes collectNodes(const tinygltf::Model& model)
{
    return Collector(model).run();
}

} // namespace crowd::model::gltf
