// SPDX-License-Identifier: MIT
#include "model/gltf/GltfMeshes.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "model/gltf/FlatNormals.h"
#include "model/gltf/GltfBones.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfLevels.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfMaterials.h"
#include "model/gltf/GltfNames.h"
#include "model/gltf/GltfPrimitives.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

constexpr std::size_t kMaxParts = 32;

/// A primitive as it goes into a level.
struct Emission
{
    PrimitiveData data;
    std::span<const std::uint16_t> bones; ///< of the skin, or the one of the node
    int slot = 0;
    int part = -1;
};

void appendInfluences(const Emission& emission, Mesh& mesh)
{
    const PrimitiveData& data = emission.data;
    const auto to = static_cast<std::size_t>(mesh.influencesPerVertex);
    const auto from = static_cast<std::size_t>(data.influences);
    for (std::size_t v = 0; v < data.positions.size(); ++v) {
        for (std::size_t i = 0; i < to; ++i) {
            if (from == 0) {
                mesh.bones.push_back(emission.bones[0]);
                mesh.weights.push_back(i == 0 ? 1.0F : 0.0F);
            } else {
                mesh.bones.push_back(emission.bones[i < from ? data.joints[v * from + i] : 0U]);
                mesh.weights.push_back(i < from ? data.weights[v * from + i] : 0.0F);
            }
        }
    }
}

/// Whether most vertices follow bones that mirror at rest, so that front faces are turned over.
bool isMirrored(const Emission& emission, const BoneTable& bones)
{
    if (emission.data.influences == 0) {
        return bones.mirrors(emission.bones[0]);
    }
    double balance = 0.0;
    for (std::size_t i = 0; i < emission.data.joints.size(); ++i) {
        const auto weight = static_cast<double>(emission.data.weights[i]);
        balance += bones.mirrors(emission.bones[emission.data.joints[i]]) ? weight : -weight;
    }
    return balance > 0.0;
}

void appendTriangles(const Emission& emission, bool mirrored, Mesh& mesh)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto firstIndex = static_cast<std::uint32_t>(mesh.indices.size());
    const std::vector<std::uint32_t>& indices = emission.data.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        mesh.indices.push_back(first + indices[i]);
        mesh.indices.push_back(first + indices[mirrored ? i + 2 : i + 1]);
        mesh.indices.push_back(first + indices[mirrored ? i + 1 : i + 2]);
    }
    const auto count = static_cast<std::uint32_t>(mesh.indices.size()) - firstIndex;
    if (count > 0) {
        mesh.submeshes.push_back({emission.slot, emission.part, firstIndex, count});
    }
}

class MeshBuilder
{
public:
    MeshBuilder(GltfFile& file, const SceneNodes& scene, Template& asset,
                const std::function<bool(float)>& report)
        : m_model(*file.model), m_scene(scene), m_asset(asset), m_report(report),
          m_slots(file, asset.warnings), m_bones(m_model, scene, asset.bones)
    {
    }

    Result<void> run()
    {
        const auto plan = planLevels(m_model, m_scene, m_asset.warnings);
        findJoints();
        if (Result<void> counted = countPrimitives(plan); !counted) {
            return counted;
        }
        announceSlots(plan);
        for (const std::vector<MeshUse>& level : plan) {
            if (Result<void> built = buildLevel(level); !built) {
                return built;
            }
        }
        m_asset.slots = m_slots.takeSlots();
        m_asset.images = m_slots.takeImages();
        addSummaries();
        return {};
    }

private:
    const tinygltf::Node& fileNode(int node) const
    {
        const int index = m_scene.fileNode[static_cast<std::size_t>(node)];
        return m_model.nodes[static_cast<std::size_t>(index)];
    }

    const tinygltf::Mesh& meshOf(const MeshUse& use) const
    {
        return m_model.meshes[static_cast<std::size_t>(fileNode(use.node).mesh)];
    }

    /// A mesh may be used by many nodes, so that a small file can ask for a lot.
    Result<void> countPrimitives(const std::vector<std::vector<MeshUse>>& plan)
    {
        std::uint64_t primitives = 0;
        for (const std::vector<MeshUse>& level : plan) {
            m_total += level.size();
            for (const MeshUse& use : level) {
                primitives += meshOf(use).primitives.size();
            }
        }
        return primitives <= kMaxPrimitives
                   ? Result<void>()
                   : Error{QT_TRANSLATE_NOOP("Messages",
                                             "%1: its nodes draw %2 primitives, more than %3"),
                           "scenes", primitives, kMaxPrimitives};
    }

    void findJoints()
    {
        m_isJoint.assign(m_scene.nodes.size(), 0);
        std::set<int> seen;
        for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
            const int skin = fileNode(static_cast<int>(i)).skin;
            if (skin < 0 || !seen.insert(skin).second) {
                continue;
            }
            for (const int joint : m_model.skins[static_cast<std::size_t>(skin)].joints) {
                m_isJoint[static_cast<std::size_t>(
                    m_scene.ofFileNode[static_cast<std::size_t>(joint)])] = 1;
            }
        }
        m_asset.jointCount =
            static_cast<int>(std::count(m_isJoint.begin(), m_isJoint.end(), char{1}));
        m_hangsOnJoint = m_isJoint;
        for (std::size_t i = 0; i < m_scene.nodes.size(); ++i) {
            const int parent = m_scene.nodes[i].parent;
            if (parent >= 0 && m_hangsOnJoint[static_cast<std::size_t>(parent)] != 0) {
                m_hangsOnJoint[i] = 1;
            }
        }
    }

    void announceSlots(const std::vector<std::vector<MeshUse>>& plan)
    {
        for (const std::vector<MeshUse>& level : plan) {
            for (const MeshUse& use : level) {
                if (!m_slotsOfMesh.try_emplace(fileNode(use.node).mesh).second) {
                    continue;
                }
                for (const tinygltf::Primitive& primitive : meshOf(use).primitives) {
                    if (drawsTriangles(primitive)) {
                        m_slots.add(primitive);
                    }
                }
            }
        }
        m_slots.finish();
        for (auto& [mesh, ofPrimitives] : m_slotsOfMesh) {
            for (const auto& primitive :
                 m_model.meshes[static_cast<std::size_t>(mesh)].primitives) {
                ofPrimitives.push_back(drawsTriangles(primitive) ? m_slots.slotOf(primitive) : -1);
            }
        }
    }

    Result<void> buildLevel(const std::vector<MeshUse>& uses)
    {
        Mesh& mesh = m_asset.levels.emplace_back();
        mesh.influencesPerVertex = influencesOf(uses);
        std::vector<FlatRun> flat;
        for (const MeshUse& use : uses) {
            if (!m_report(static_cast<float>(m_done++) / static_cast<float>(m_total))) {
                return Error{kCancelled};
            }
            if (Result<void> added = addMesh(use, mesh, flat); !added) {
                return added;
            }
        }
        mesh.fileVertexCount = mesh.positions.size();
        computeFlatNormals(mesh, flat);
        return {};
    }

    bool isSkinned(const MeshUse& use, const tinygltf::Primitive& primitive) const
    {
        return fileNode(use.node).skin >= 0 && primitive.attributes.contains("JOINTS_0") &&
               primitive.attributes.contains("WEIGHTS_0");
    }

    int influencesOf(const std::vector<MeshUse>& uses) const
    {
        int influences = 1;
        for (const MeshUse& use : uses) {
            for (const tinygltf::Primitive& primitive : meshOf(use).primitives) {
                int sets = 0;
                while (isSkinned(use, primitive) && sets < 4 &&
                       primitive.attributes.contains("JOINTS_" + std::to_string(sets)) &&
                       primitive.attributes.contains("WEIGHTS_" + std::to_string(sets))) {
                    ++sets;
                }
                influences = std::max(influences, sets * 4);
            }
        }
        return influences;
    }

    Result<void> addMesh(const MeshUse& use, Mesh& mesh, std::vector<FlatRun>& flat)
    {
        const tinygltf::Node& node = fileNode(use.node);
        const tinygltf::Mesh& from = meshOf(use);
        for (std::size_t i = 0; i < from.primitives.size(); ++i) {
            const tinygltf::Primitive& primitive = from.primitives[i];
            if (!drawsTriangles(primitive)) {
                ++m_undrawn;
                continue;
            }
            m_hasMorphs = m_hasMorphs || !primitive.targets.empty();
            PrimitiveRequest request;
            request.texCoord = m_slots.texCoordOf(primitive);
            request.morphWeights = node.weights.empty() ? from.weights : node.weights;
            request.place =
                place("meshes", static_cast<std::size_t>(node.mesh)) + "." + place("primitives", i);
            if (Result<void> fits = takeBudget(primitive, request.place); !fits) {
                return fits;
            }
            const bool skinned = isSkinned(use, primitive);
            if (skinned) {
                request.joints = m_model.skins[static_cast<std::size_t>(node.skin)].joints.size();
            }
            Result<PrimitiveData> data = decodePrimitive(m_model, primitive, request);
            if (!data) {
                return data.error();
            }
            Emission emission{std::move(data).value(), {}, m_slotsOfMesh[node.mesh][i], -1};
            const std::uint16_t own = skinned ? std::uint16_t{0} : m_bones.ofNode(use.node);
            emission.bones = skinned ? std::span(m_bones.ofSkin(node.skin)) : std::span(&own, 1);
            if (m_bones.isOverfull()) {
                return Error{QT_TRANSLATE_NOOP("Messages", "%1: more than %2 of them move meshes"),
                             "nodes", kMaxBones};
            }
            emission.part = skinned ? -1 : partOf(use);
            emit(emission, mesh, flat);
        }
        return {};
    }

    Result<void> takeBudget(const tinygltf::Primitive& primitive, const std::string& where)
    {
        const auto count = [this](int accessor) -> std::uint64_t {
            return accessor < 0 ? 0 : m_model.accessors[static_cast<std::size_t>(accessor)].count;
        };
        const std::uint64_t vertices = count(primitive.attributes.at("POSITION"));
        const bool isList = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
        m_vertices += vertices;
        m_morphed += vertices * primitive.targets.size();
        if (m_morphed > kMaxMorphed) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "%1: the morph targets have more than %2 vertices"),
                where + ".targets", kMaxMorphed};
        }
        m_corners +=
            (primitive.indices < 0 ? vertices : count(primitive.indices)) * (isList ? 1U : 3U);
        if (m_vertices > kMaxVertices || m_corners > kMaxCorners) {
            return Error{QT_TRANSLATE_NOOP(
                             "Messages", "%1: the scene has more than %2 vertices or %3 triangles"),
                         where, kMaxVertices, kMaxCorners / 3};
        }
        return {};
    }

    void emit(Emission& emission, Mesh& mesh, std::vector<FlatRun>& flat)
    {
        PrimitiveData& data = emission.data;
        addWarnings(data.warnings);
        const bool isFlat = data.normals.empty();
        const std::size_t firstIndex = mesh.indices.size();
        const bool mirrored = isMirrored(emission, m_bones);
        appendTriangles(emission, mirrored, mesh);
        if (isFlat) {
            flat.push_back({firstIndex, mesh.indices.size(), mirrored});
            data.normals.assign(data.positions.size(), glm::vec3(0.0F));
        }
        appendInfluences(emission, mesh);
        mesh.positions.insert(mesh.positions.end(), data.positions.begin(), data.positions.end());
        mesh.normals.insert(mesh.normals.end(), data.normals.begin(), data.normals.end());
        mesh.uv.insert(mesh.uv.end(), data.uv.begin(), data.uv.end());
        mesh.colors.insert(mesh.colors.end(), data.colors.begin(), data.colors.end());
    }

    /// Coarser levels repeat the warnings of finer ones that they share a mesh with.
    void addWarnings(const std::vector<Message>& warnings)
    {
        for (const Message& warning : warnings) {
            if (m_seenWarnings.insert(warning.english()).second) {
                m_asset.warnings.push_back(warning);
            }
        }
    }

    /// A mesh without skin that hangs on a joint is a part; the same for all its levels.
    int partOf(const MeshUse& use)
    {
        if (m_hangsOnJoint[static_cast<std::size_t>(use.node)] == 0) {
            return -1;
        }
        const auto known = m_partOfObject.find(use.object);
        if (known != m_partOfObject.end()) {
            return known->second;
        }
        int part = -1;
        if (m_asset.parts.size() < kMaxParts) {
            part = static_cast<int>(m_asset.parts.size());
            const std::string name = use.name.empty() ? "part_" + std::to_string(part) : use.name;
            m_asset.parts.push_back({m_partNames.unique(name), isShown(use)});
        } else if (!m_hasTooManyParts) {
            m_hasTooManyParts = true;
            m_asset.warnings.emplace_back(
                QT_TRANSLATE_NOOP("Messages", "Only the first %1 parts can be hidden; \"%2\" and "
                                              "those after it are always shown."),
                kMaxParts, use.name);
        }
        m_partOfObject[use.object] = part;
        return part;
    }

    /// A part may start hidden: extras of its node say "shown": false.
    bool isShown(const MeshUse& use) const
    {
        const int node = m_scene.fileNode[static_cast<std::size_t>(use.node)];
        const tinygltf::Value& extras = m_model.nodes[static_cast<std::size_t>(node)].extras;
        return flagIn(extras, "shown").value_or(true);
    }

    void addSummaries()
    {
        if (m_asset.levels.front().indices.empty()) {
            m_asset.warnings.emplace_back(QT_TRANSLATE_NOOP(
                "Messages", "The file draws nothing: its scene has no triangles."));
        }
        if (m_undrawn > 0) {
            m_asset.warnings.emplace_back(
                QT_TRANSLATE_NOOP(
                    "Messages",
                    "%1 primitives are points or lines or have no positions; they are not drawn."),
                m_undrawn);
        }
        if (m_hasMorphs) {
            m_asset.warnings.emplace_back(QT_TRANSLATE_NOOP(
                "Messages", "Morph targets are not animated: the mesh keeps its resting shape."));
        }
    }

    const tinygltf::Model& m_model;
    const SceneNodes& m_scene;
    Template& m_asset;
    const std::function<bool(float)>& m_report;
    SlotTable m_slots;
    BoneTable m_bones;
    std::map<int, std::vector<int>> m_slotsOfMesh; ///< one a primitive, -1 for what is not drawn
    std::vector<char> m_isJoint;
    std::vector<char> m_hangsOnJoint; ///< is one, or is below one
    std::map<int, int> m_partOfObject;
    NameSet m_partNames;
    std::set<std::string> m_seenWarnings;
    std::uint64_t m_vertices = 0;
    std::uint64_t m_corners = 0;
    std::uint64_t m_morphed = 0;
    std::size_t m_done = 0;
    std::size_t m_total = 0;
    std::size_t m_undrawn = 0;
    bool m_hasMorphs = false;
    bool m_hasTooManyParts = false;
};

} // namespace

Result<void> buildMeshes(GltfFile& file, const SceneNodes& scene, Template& asset,
                         const std::function<bool(float)>& report)
{
    return MeshBuilder(file, scene, asset, report).run();
}

} // namespace crowd::model::gltf
