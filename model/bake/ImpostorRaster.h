// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/bake/Impostor.h"

namespace crowd::model {

/// Draws a template's finest level onto cards, each texel from several samples: what most of them
/// show is there. Holds scratch memory: one per thread.
class ImpostorRaster
{
public:
    /// All of them must outlive this.
    ImpostorRaster(const Template& asset, const BakedClip& clip, const ImpostorLayout& layout);

    /// The pose that the next cards show.
    void take(int keyframe);
    /// `out`: the layers of a card, one after the other.
    void draw(const CardAxes& axes, std::span<ImpostorTexel> out);

private:
    /// What is nearest at a place.
    struct Sample
    {
        float depth = 0.0F; ///< metres towards the eye
        std::uint32_t triangle = kNothing;
        glm::vec2 shares{0.0F}; ///< of its second and third corner
    };
    static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
    struct Triangle
    {
        std::uint32_t a, b, c; ///< vertices
        std::uint8_t slot;
        std::uint8_t part;
        bool isDoubleSided;
    };

    void collectTriangles();
    void drawTriangle(std::uint32_t index, std::span<Sample> samples) const;
    void resolve(std::span<ImpostorTexel> out) const;
    [[nodiscard]] ImpostorTexel texelAt(glm::ivec2 at) const;
    [[nodiscard]] ImpostorTexel texelOf(const Sample& sample, const glm::vec3& normal,
                                        float depth) const;

    const Template& m_asset;
    const BakedClip& m_clip;
    const ImpostorLayout& m_layout;
    std::vector<Triangle> m_triangles;
    std::vector<glm::vec3> m_positions; ///< of the pose
    std::vector<glm::vec3> m_normals;
    std::vector<glm::vec3>
        m_onCard;                ///< samples right and up from the corner, metres towards the eye
    glm::ivec2 m_size{0};        ///< samples
    std::vector<Sample> m_whole; ///< with parts that can be hidden
    std::vector<Sample> m_bare;  ///< without
    const std::vector<Sample>* m_shown = nullptr;
};

} // namespace crowd::model
