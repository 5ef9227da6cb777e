// SPDX-License-Identifier: MIT
#include "model/gltf/GltfStage.h"

#include <algorithm>
#include <cmath>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

constexpr std::uint32_t kUnused = ~std::uint32_t{0};

/// Distributes the triangles of level 0 over one mesh a material, keeping their order.
class Flattener
{
public:
    Flattener(const Template& asset, StageAsset& stage)
        : m_mesh(asset.levels.front()), m_stage(stage), m_positions(m_mesh.positions.size()),
          m_normals(m_mesh.positions.size())
    {
        Pose pose;
        evaluatePose(asset, -1, 0.0F, pose);
        skin(m_mesh, pose.bones, m_positions, m_normals);
        m_hasColors = std::any_of(m_mesh.colors.begin(), m_mesh.colors.end(),
                                  [](const glm::u8vec4& c) { return c != glm::u8vec4(255); });
    }

    void run()
    {
        std::vector<std::vector<const Submesh*>> ofSlot(m_stage.materials.size());
        for (const Submesh& submesh : m_mesh.submeshes) {
            ofSlot[static_cast<std::size_t>(submesh.slot)].push_back(&submesh);
        }
        m_newIndex.assign(m_mesh.positions.size(), kUnused);
        for (std::size_t slot = 0; slot < ofSlot.size(); ++slot) {
            addMaterial(static_cast<int>(slot), ofSlot[slot]);
        }
    }

private:
    void addMaterial(int slot, const std::vector<const Submesh*>& submeshes)
    {
        StageMesh out;
        out.material = slot;
        for (const Submesh* submesh : submeshes) {
            for (std::uint32_t i = 0; i < submesh->indexCount; ++i) {
                addCorner(m_mesh.indices[submesh->firstIndex + i], out);
            }
        }
        for (const Submesh* submesh : submeshes) {
            for (std::uint32_t i = 0; i < submesh->indexCount; ++i) {
                m_newIndex[m_mesh.indices[submesh->firstIndex + i]] = kUnused;
            }
        }
        if (!out.indices.empty()) {
            m_stage.meshes.push_back(std::move(out));
        }
    }

    void addCorner(std::uint32_t vertex, StageMesh& out)
    {
        if (m_newIndex[vertex] == kUnused) {
            m_newIndex[vertex] = static_cast<std::uint32_t>(out.positions.size());
            out.positions.push_back(m_positions[vertex]);
            out.normals.push_back(m_normals[vertex]);
            out.uv.push_back(m_mesh.uv[vertex]);
            if (m_hasColors) {
                out.colors.push_back(glm::vec4(m_mesh.colors[vertex]) / 255.0F);
            }
            m_stage.bounds.addPlace(m_positions[vertex]);
        }
        out.indices.push_back(m_newIndex[vertex]);
    }

    const Mesh& m_mesh;
    StageAsset& m_stage;
    std::vector<glm::vec3> m_positions;
    std::vector<glm::vec3> m_normals;
    std::vector<std::uint32_t> m_newIndex;
    bool m_hasColors = false;
};

bool readSeat(const Json& from, const glm::mat4& world, Seat& seat)
{
    const Json& position = member(from, "position");
    if (!position.is_array() || position.size() != 3) {
        return false;
    }
    glm::vec3 local(0.0F);
    for (int i = 0; i < 3; ++i) {
        const Json& value = position[static_cast<std::size_t>(i)];
        local[i] = value.is_number() ? value.get<float>() : NAN;
    }
    const auto number = [&](const char* key) {
        const Json& value = member(from, key);
        return value.is_number() ? value.get<double>() : 0.0;
    };
    const auto heading = static_cast<float>(number("headingRadians"));
    const glm::vec3 facing =
        glm::mat3(world) * glm::vec3(std::sin(heading), 0.0F, std::cos(heading));
    seat.position = glm::vec3(world * glm::vec4(local, 1.0F));
    seat.headingRadians = std::atan2(facing.x, facing.z);
    seat.height = static_cast<float>(number("height")) * glm::length(glm::vec3(world[1]));
    seat.rank = static_cast<int>(std::clamp(number("rank"), -1e6, 1e6));
    seat.wedge = static_cast<int>(std::clamp(number("wedge"), -1e6, 1e6));
    return std::isfinite(seat.position.x + seat.position.y + seat.position.z) &&
           std::isfinite(seat.headingRadians) && std::isfinite(seat.height);
}

Json toJson(const tinygltf::Value& value)
{
    if (value.IsArray()) {
        Json list = Json::array();
        for (std::size_t i = 0; i < value.ArrayLen(); ++i) {
            list.push_back(toJson(value.Get(static_cast<int>(i))));
        }
        return list;
    }
    if (value.IsObject()) {
        Json object = Json::object();
        for (const std::string& key : value.Keys()) {
            object[key] = toJson(value.Get(key));
        }
        return object;
    }
    return value.IsNumber() ? Json(value.GetNumberAsDouble()) : Json();
}

/// The list may also be written as text, which is how Blender keeps structured properties.
void addSeats(const tinygltf::Value& extras, const glm::mat4& world, StageAsset& stage)
{
    const tinygltf::Value* value = find(extras, "seats");
    if (value == nullptr) {
        return;
    }
    Json list = value->IsArray() ? toJson(*value) : Json();
    if (value->IsString()) {
        Result<Json> parsed = parseJson("{\"seats\":" + value->Get<std::string>() + "}");
        list = parsed ? parsed.value()["seats"] : Json();
    }
    std::size_t bad = list.is_array() ? 0 : 1;
    for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
        Seat seat;
        if (readSeat(list[i], world, seat)) {
            stage.seats.push_back(seat);
        } else {
            ++bad;
        }
    }
    if (bad > 0) {
        stage.warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "%1 seats of the extras cannot be read and are left out."),
            bad);
    }
}

} // namespace

StagePtr flattenStage(const tinygltf::Model& model, const SceneNodes& scene, Template asset)
{
    auto stage = std::make_shared<StageAsset>();
    stage->name = asset.name;
    stage->warnings = std::move(asset.warnings);
    stage->images = std::move(asset.images);
    for (const Slot& slot : asset.slots) {
        stage->materials.push_back(slot.choices.front());
        stage->materials.back().name = slot.name;
    }
    stage->fileVertexCount = asset.levels.front().fileVertexCount;
    Flattener(asset, *stage).run();
    addSeats(model.asset.extras, glm::mat4(1.0F), *stage);
    addSeats(model.extras, glm::mat4(1.0F), *stage);
    if (!model.scenes.empty()) {
        const auto shown = static_cast<std::size_t>(std::max(model.defaultScene, 0));
        addSeats(model.scenes[shown].extras, glm::mat4(1.0F), *stage);
    }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const auto node = static_cast<std::size_t>(scene.fileNode[i]);
        if (scene.isDrawn[i] != 0) {
            addSeats(model.nodes[node].extras, scene.restWorld[i], *stage);
        }
    }
    return stage;
}

} // namespace crowd::model::gltf
