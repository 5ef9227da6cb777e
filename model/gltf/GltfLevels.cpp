// SPDX-License-Identifier: MIT
#include "model/gltf/GltfLevels.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

struct LodName
{
    std::string base;
    int level = 0;
};

/// "Body_LOD2" is level 2 of "Body"; any case, and Blender's ".001" may follow.
std::optional<LodName> parseLodName(std::string name)
{
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && dot + 4 == name.size() &&
        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dot) + 1, name.end(),
                    [](char c) { return c >= '0' && c <= '9'; })) {
        name.resize(dot);
    }
    if (name.size() < 5 || name.back() < '0' || name.back() > '9') {
        return std::nullopt;
    }
    std::string suffix = name.substr(name.size() - 5, 4);
    std::transform(suffix.begin(), suffix.end(), suffix.begin(), lower);
    if (suffix != "_lod") {
        return std::nullopt;
    }
    return LodName{name.substr(0, name.size() - 5), name.back() - '0'};
}

/// One thing with the mesh nodes of each of its levels, keyed by level.
struct Object
{
    std::string name;
    std::map<int, std::vector<int>> levels;
};

class Planner
{
public:
    Planner(const tinygltf::Model& model, const SceneNodes& scene) : m_model(model), m_scene(scene)
    {
        m_children.resize(scene.nodes.size());
        m_isTaken.assign(scene.nodes.size(), 0);
        m_isWalked.assign(scene.nodes.size(), 0);
        for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
            if (scene.nodes[i].parent >= 0) {
                m_children[static_cast<std::size_t>(scene.nodes[i].parent)].push_back(
                    static_cast<int>(i));
            }
        }
    }

    std::vector<std::vector<MeshUse>> run(std::vector<Message>& warnings)
    {
        collectNamed();
        for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
            collectAlternatives(static_cast<int>(i));
        }
        std::map<std::pair<int, std::string>, std::size_t> named;
        for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
            if (isMesh(static_cast<int>(i))) {
                collectByName(static_cast<int>(i), named);
            }
        }
        return assemble(warnings);
    }

private:
    const tinygltf::Node& fileNode(int node) const
    {
        const int index = m_scene.fileNode[static_cast<std::size_t>(node)];
        return m_model.nodes[static_cast<std::size_t>(index)];
    }

    bool isMesh(int node) const
    {
        const auto i = static_cast<std::size_t>(node);
        return m_isTaken[i] == 0 && m_scene.isDrawn[i] != 0 && fileNode(node).mesh >= 0;
    }

    /// All nodes that something names as its alternative: they are not drawn on their own.
    void collectNamed()
    {
        for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
            for (const int other : alternatives(fileNode(static_cast<int>(i)))) {
                m_alternatives.insert(m_scene.ofFileNode[static_cast<std::size_t>(other)]);
            }
        }
    }

    std::vector<int> takeMeshes(int root)
    {
        std::vector<int> meshes;
        std::vector<int> stack{root};
        while (!stack.empty()) {
            const int node = stack.back();
            stack.pop_back();
            if (std::exchange(m_isWalked[static_cast<std::size_t>(node)], 1) != 0) {
                continue; // all below it is taken
            }
            if (isMesh(node)) {
                m_isTaken[static_cast<std::size_t>(node)] = 1;
                meshes.push_back(node);
            }
            for (const int child : m_children[static_cast<std::size_t>(node)]) {
                if (!m_alternatives.contains(child)) {
                    stack.push_back(child);
                }
            }
        }
        return meshes;
    }

    void collectAlternatives(int node)
    {
        const std::vector<int> others = alternatives(fileNode(node));
        if (others.empty() || m_alternatives.contains(node)) {
            return;
        }
        Object object{displayName(node), {}};
        object.levels[0] = takeMeshes(node);
        for (std::size_t i = 0; i < others.size(); ++i) {
            const int other = m_scene.ofFileNode[static_cast<std::size_t>(others[i])];
            std::vector<int> meshes = takeMeshes(other);
            if (!meshes.empty()) {
                object.levels[static_cast<int>(i) + 1] = std::move(meshes);
            }
        }
        m_objects.push_back(std::move(object));
    }

    std::string displayName(int node) const
    {
        const tinygltf::Node& from = fileNode(node);
        const std::string& name = from.name.empty() && from.mesh >= 0
                                      ? m_model.meshes[static_cast<std::size_t>(from.mesh)].name
                                      : from.name;
        const std::optional<LodName> lod = parseLodName(name);
        return lod ? lod->base : name;
    }

    void collectByName(int node, std::map<std::pair<int, std::string>, std::size_t>& named)
    {
        m_isTaken[static_cast<std::size_t>(node)] = 1;
        const tinygltf::Node& from = fileNode(node);
        std::optional<LodName> lod = parseLodName(from.name);
        if (!lod) {
            lod = parseLodName(m_model.meshes[static_cast<std::size_t>(from.mesh)].name);
        }
        if (!lod) {
            m_objects.push_back({displayName(node), {{0, {node}}}});
            return;
        }
        const int parent = m_scene.nodes[static_cast<std::size_t>(node)].parent;
        const auto [at, isNew] = named.try_emplace({parent, lod->base}, m_objects.size());
        if (isNew) {
            m_objects.push_back({lod->base, {}});
        }
        m_objects[at->second].levels[lod->level].push_back(node);
    }

    std::vector<std::vector<MeshUse>> assemble(std::vector<Message>& warnings) const
    {
        int last = 0;
        for (const Object& object : m_objects) {
            last = std::max(last, object.levels.rbegin()->first - object.levels.begin()->first);
        }
        if (last >= kMaxLevels) {
            warnings.emplace_back(
                QT_TRANSLATE_NOOP("Messages",
                                  "The file has %1 levels of detail; the finest %2 are used."),
                last + 1, kMaxLevels);
            last = kMaxLevels - 1;
        }
        std::vector<std::vector<MeshUse>> levels(static_cast<std::size_t>(last) + 1);
        for (std::size_t level = 0; level < levels.size(); ++level) {
            for (std::size_t i = 0; i < m_objects.size(); ++i) {
                const auto& of = m_objects[i].levels;
                const auto above = of.upper_bound(of.begin()->first + static_cast<int>(level));
                for (const int node : std::prev(above)->second) {
                    levels[level].push_back({node, static_cast<int>(i), m_objects[i].name});
                }
            }
            std::sort(levels[level].begin(), levels[level].end(),
                      [](const MeshUse& a, const MeshUse& b) { return a.node < b.node; });
        }
        return levels;
    }

    const tinygltf::Model& m_model;
    const SceneNodes& m_scene;
    std::vector<std::vector<int>> m_children;
    std::vector<char> m_isTaken;
    std::vector<char> m_isWalked; ///< by takeMeshes
    std::set<int> m_alternatives;
    std::vector<Object> m_objects;
};

} // namespace

std::vector<std::vector<MeshUse>> planLevels(const tinygltf::Model& model, const SceneNodes& scene,
                                             std::vector<Message>& warnings)
{
    return Planner(model, scene).run(warnings);
}

} // namespace crowd::model::gltf
