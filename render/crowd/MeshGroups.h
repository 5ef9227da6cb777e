// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "model/bake/DrawLevels.h"
#include "model/template/Template.h"

/// The triangles of a level arranged for drawing: what needs the same GL state lies together. No
/// GL.
namespace crowd::render {

/// What decides on shader variant and GL state, over all choices of a slot.
struct GroupState
{
    bool isTextured = false;
    bool isMasked = false; ///< some tint mask
    bool isDoubleSided = false;
    bool isSpecial = false; ///< unlit or emissive
    bool isGlowing = false; ///< emissive by a picture
    int pictures = 0;       ///< index into TemplateImages::arrays
    model::AlphaMode alphaMode = model::AlphaMode::Opaque;
    // NOLINTNEXTLINE(modernize-use-nullptr): the checker means the compared zero
    friend auto operator<=>(const GroupState&, const GroupState&) = default;
};

[[nodiscard]] GroupState groupStateOf(const model::Slot& slot, int pictures = 0);

/// Which of a group's fragments are drawn. Those of blended materials that are solid hide what is
/// behind them as others do; the rest is blended over it when all that is solid has been drawn.
/// Caster: depth alone, of what is solid.
enum class Surface : std::uint8_t { Solid, SeeThrough, Caster };

/// Words for ShaderProgram::build.
[[nodiscard]] std::string definesOf(const GroupState& state, Surface surface);

struct MeshGroup
{
    GroupState state;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
};

/// Static attributes of a vertex; its position and normal come from the keyframes.
struct StaticVertex
{
    glm::vec2 uv{0.0F};
    glm::u8vec4 color{255};
    std::uint32_t source = 0; ///< vertex within a keyframe
    std::uint16_t slot = 0;
    std::uint16_t part = 255; ///< 255: always shown
};
static_assert(sizeof(StaticVertex) == 20);

struct GroupedMesh
{
    std::vector<StaticVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<MeshGroup> groups; ///< opaque first, blended last
};

/// A vertex that several slots or parts use is doubled.
[[nodiscard]] GroupedMesh groupMesh(const model::Template& asset, const model::DrawLevel& level);

} // namespace crowd::render
