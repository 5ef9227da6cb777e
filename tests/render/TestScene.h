// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "render/OffscreenContext.h"
#include "render/Renderer.h"

/// A character of three boxes, built in code, and what it takes to draw some of it.
namespace crowd::testing {

/// Appends a box of one slot and part that follows bone 0.
inline void addBox(model::Mesh& mesh, const glm::vec3& low, const glm::vec3& high, int slot,
                   int part = -1)
{
    struct Side
    {
        glm::vec3 normal, u, v;
    };
    const std::array<Side, 6> sides{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                     {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};
    const glm::vec3 center = (low + high) * 0.5F;
    const glm::vec3 half = (high - low) * 0.5F;
    model::Submesh submesh{slot, part, static_cast<std::uint32_t>(mesh.indices.size()), 36};
    for (const Side& side : sides) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int corner = 0; corner < 4; ++corner) {
            const float a = (corner & 1) != 0 ? 1.0F : -1.0F;
            const float b = (corner & 2) != 0 ? 1.0F : -1.0F;
            mesh.positions.push_back(center + half * (side.normal + side.u * a + side.v * b));
            mesh.normals.push_back(side.normal);
            mesh.uv.emplace_back(a * 0.5F + 0.5F, b * 0.5F + 0.5F);
            mesh.colors.emplace_back(255, 255, 255, 255);
            mesh.bones.push_back(0);
            mesh.weights.push_back(1.0F);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) {
            mesh.indices.push_back(first + corner);
        }
    }
    mesh.submeshes.push_back(submesh);
}

/// Four corners, counter-clockwise as seen from where it faces; of one white material.
inline std::shared_ptr<model::StageAsset> makeSheet(const std::array<glm::vec3, 4>& corners)
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    model::StageMesh sheet;
    sheet.positions.assign(corners.begin(), corners.end());
    sheet.normals.assign(
        4, glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0])));
    sheet.uv.assign(4, glm::vec2(0));
    sheet.indices = {0, 1, 2, 0, 2, 3};
    for (const glm::vec3& corner : corners) {
        stage->bounds.add(corner);
    }
    stage->meshes.push_back(sheet);
    return stage;
}

/// 1.8 m high, faces +Z: white legs (slot 0 "bottom"), a body (slot 1 "top": white, or blue as
/// choice 1), a grey hat (slot 2, not tintable, part 0). Clip 0 stands; clip 1 moves a metre up in
/// a second and a half; clip 2 sits with its seat plane at 0.5 m. `levels` copies of the mesh.
inline std::shared_ptr<model::Template> makeBoxMan(int levels = 1)
{
    auto asset = std::make_shared<model::Template>();
    asset->name = "box man";
    asset->nodes.emplace_back().name = "root";
    asset->bones.push_back({0, glm::mat4(1.0F)});
    model::Mesh mesh;
    addBox(mesh, {-0.3F, 0.0F, -0.2F}, {0.3F, 0.8F, 0.2F}, 0);
    addBox(mesh, {-0.3F, 0.8F, -0.2F}, {0.3F, 1.5F, 0.2F}, 1);
    addBox(mesh, {-0.2F, 1.5F, -0.2F}, {0.2F, 1.8F, 0.2F}, 2, 0);
    asset->levels.assign(static_cast<std::size_t>(levels), mesh);
    model::MaterialChoice white;
    model::MaterialChoice blue;
    blue.name = "blue";
    blue.baseColor = {0.0F, 0.0F, 1.0F, 1.0F};
    model::MaterialChoice grey;
    grey.baseColor = {0.2F, 0.2F, 0.2F, 1.0F};
    asset->slots = {{"bottom", true, true, {white}},
                    {"top", true, true, {white, blue}},
                    {"hat", false, false, {grey}}};
    asset->parts = {{"hat", true}};
    model::Clip stand;
    stand.name = "stand";
    model::Clip rise;
    rise.name = "rise";
    rise.seconds = 1.5F;
    rise.channels.push_back({0,
                             model::ChannelPath::Translation,
                             model::Interpolation::Linear,
                             {0.0F, 1.5F},
                             {0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}});
    model::Clip sit;
    sit.name = "sit";
    sit.seatHeight = 0.5F;
    asset->clips = {stand, rise, sit};
    asset->bounds.add(glm::vec3(-0.3F, 0.0F, -0.2F));
    asset->bounds.add(glm::vec3(0.3F, 1.8F, 0.2F));
    asset->height = 1.8F;
    return asset;
}

/// The scene's template entry 1 for an asset.
inline model::TemplateEntry entryFor(const model::TemplatePtr& asset, model::TemplateId id = 1)
{
    model::TemplateEntry entry;
    entry.id = id;
    entry.name = asset->name;
    entry.asset = asset;
    for (const model::Clip& clip : asset->clips) {
        entry.clipNames.push_back(clip.name);
    }
    return entry;
}

/// `count` individuals of template 1 with ids from 1, a metre apart along X, at defaults otherwise.
inline model::Population makeRow(std::size_t count)
{
    std::vector<model::IndividualId> ids(count);
    for (std::size_t i = 0; i < count; ++i) {
        ids[i] = static_cast<model::IndividualId>(i + 1);
    }
    model::IndividualRows rows = model::IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < count; ++i) {
        rows.column(model::columns::templateId)[i] = 1;
        rows.column(model::columns::position)[i] = {static_cast<float>(i), 0.0F, 0.0F};
        rows.column(model::columns::height)[i] = 1.0F;
        rows.column(model::columns::girth)[i] = 1.0F;
        rows.column(model::columns::parts)[i] = 1;
    }
    model::Population population;
    population.add(rows);
    return population;
}

template<class T>
void setAll(model::Population& population, model::ColumnKey<T> key, const T& value)
{
    const std::vector<model::IndividualId> ids(population.ids().begin(), population.ids().end());
    population.setValues(key, ids, std::span<const T>(&value, 1));
}

inline model::CrowdFramePtr frameOf(const model::Population& population,
                                    std::vector<model::TemplateEntry> entries, double seconds = 0.0)
{
    auto frame = std::make_shared<model::CrowdFrame>();
    frame->population = population;
    frame->templates =
        std::make_shared<const std::vector<model::TemplateEntry>>(std::move(entries));
    frame->seconds = seconds;
    return frame;
}

/// Looks straight at the character at the origin, from the front.
inline model::View frontView(glm::vec2 size = glm::vec2(64.0F), float distance = 4.0F)
{
    return {model::Camera::lookingAt({0.0F, 0.9F, distance}, {0.0F, 0.9F, 0.0F}), size};
}

} // namespace crowd::testing
