// SPDX-License-Identifier: MIT
#include "model/bake/ImpostorRaster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/bake/Octahedral.h"

namespace crowd::model {

namespace {

constexpr int kSamples = 3;                                  ///< of a texel, each way
constexpr int kLeastCovered = (kSamples * kSamples + 1) / 2; ///< of them, to be something

/// A share of 0..1 in so many steps.
std::uint32_t stepOf(float share, float steps)
{
    return static_cast<std::uint32_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * steps));
}

/// Where in a repeated picture.
std::uint32_t wrapped(float coordinate)
{
    const float within = coordinate - std::floor(coordinate);
    return within >= 0.0F ? std::min(static_cast<std::uint32_t>(within * 256.0F), 255U) : 0U;
}

bool isDoubleSided(const Slot& slot)
{
    return std::ranges::any_of(slot.choices, &MaterialChoice::doubleSided);
}

} // namespace

ImpostorRaster::ImpostorRaster(const Template& asset, const BakedClip& clip,
                               const ImpostorLayout& layout)
    : m_asset(asset), m_clip(clip), m_layout(layout), m_size(layout.texels * kSamples)
{
    collectTriangles();
    const auto samples = static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y);
    m_whole.resize(samples);
    m_bare.resize(layout.layers > 1 ? samples : 0);
}

/// Those without a part first: what is drawn of them is drawn once for both layers.
void ImpostorRaster::collectTriangles()
{
    const Mesh& mesh = m_asset.levels.front();
    for (const bool arePartsWanted : {false, true}) {
        for (const Submesh& submesh : mesh.submeshes) {
            if ((submesh.part >= 0) != arePartsWanted) {
                continue;
            }
            const Slot& slot = m_asset.slots[static_cast<std::size_t>(submesh.slot)];
            const auto part = submesh.part < 0 ? ImpostorTexel::kNoPart
                                               : static_cast<std::uint32_t>(submesh.part);
            for (std::uint32_t i = 0; i + 2 < submesh.indexCount; i += 3) {
                const std::uint32_t* corner = &mesh.indices[submesh.firstIndex + i];
                m_triangles.push_back({corner[0], corner[1], corner[2],
                                       static_cast<std::uint8_t>(submesh.slot),
                                       static_cast<std::uint8_t>(part), isDoubleSided(slot)});
            }
        }
    }
}

void ImpostorRaster::take(int keyframe)
{
    const std::size_t vertices = m_asset.levels.front().positions.size();
    m_positions.resize(vertices);
    m_normals.resize(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        m_positions[v] = m_clip.position(0, keyframe, v);
        m_normals[v] = m_clip.normal(0, keyframe, v);
    }
}

void ImpostorRaster::draw(const CardAxes& axes, std::span<ImpostorTexel> out)
{
    const glm::vec3 middle(0.0F, m_layout.middle, 0.0F);
    const glm::vec2 perMetre = glm::vec2(m_size) / m_layout.size;
    m_onCard.resize(m_positions.size());
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
        const glm::vec3 p = m_positions[v] - middle;
        const glm::vec2 at(glm::dot(p, axes.right), glm::dot(p, axes.up));
        m_onCard[v] = glm::vec3((at - m_layout.low) * perMetre, glm::dot(p, axes.towards));
    }
    std::ranges::fill(m_whole, Sample{});
    const auto isOfPart = [](const Triangle& each) { return each.part != ImpostorTexel::kNoPart; };
    const auto firstPart = std::ranges::find_if(m_triangles, isOfPart) - m_triangles.begin();
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
        if (static_cast<std::ptrdiff_t>(i) == firstPart && m_layout.layers > 1) {
            m_bare = m_whole;
        }
        drawTriangle(static_cast<std::uint32_t>(i), m_whole);
    }
    const std::size_t layer = out.size() / static_cast<std::size_t>(m_layout.layers);
    m_shown = &m_whole;
    resolve(out.first(layer));
    if (m_layout.layers > 1) {
        m_shown = firstPart < static_cast<std::ptrdiff_t>(m_triangles.size()) ? &m_bare : &m_whole;
        resolve(out.subspan(layer));
    }
}

void ImpostorRaster::drawTriangle(std::uint32_t index, std::span<Sample> samples) const
{
    const Triangle& triangle = m_triangles[index];
    const glm::vec3& a = m_onCard[triangle.a];
    const glm::vec3& b = m_onCard[triangle.b];
    const glm::vec3& c = m_onCard[triangle.c];
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0.0F || (area < 0.0F && !triangle.isDoubleSided)) {
        return;
    }
    // Clamped before they become whole numbers: what is no number is nowhere.
    const auto first = [](float low) { return std::ceil(std::max(low - 0.5F, 0.0F)); };
    const auto last = [](float high, int size) {
        return std::floor(std::min(high - 0.5F, static_cast<float>(size - 1)));
    };
    const float x0 = first(std::min({a.x, b.x, c.x}));
    const float y0 = first(std::min({a.y, b.y, c.y}));
    const float x1 = last(std::max({a.x, b.x, c.x}), m_size.x);
    const float y1 = last(std::max({a.y, b.y, c.y}), m_size.y);
    const float inverse = 1.0F / area;
    for (float y = y0; y <= y1; y += 1.0F) {
        for (float x = x0; x <= x1; x += 1.0F) {
            const float px = x + 0.5F;
            const float py = y + 0.5F;
            const float toA = ((c.x - b.x) * (py - b.y) - (c.y - b.y) * (px - b.x)) * inverse;
            const float toB = ((a.x - c.x) * (py - c.y) - (a.y - c.y) * (px - c.x)) * inverse;
            const float toC = 1.0F - toA - toB;
            if (toA < 0.0F || toB < 0.0F || toC < 0.0F) {
                continue;
            }
            Sample& sample =
                samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x) +
                        static_cast<std::size_t>(x)];
            const float depth = toA * a.z + toB * b.z + toC * c.z;
            if (sample.triangle == kNothing || depth > sample.depth) {
                sample = {depth, index, {toB, toC}};
            }
        }
    }
}

void ImpostorRaster::resolve(std::span<ImpostorTexel> out) const
{
    std::size_t next = 0;
    for (int y = 0; y < m_layout.texels.y; ++y) {
        for (int x = 0; x < m_layout.texels.x; ++x) {
            out[next++] = texelAt({x, y});
        }
    }
}

/// What most samples are of, as the one nearest to the middle shows it, lit by the mean normal.
ImpostorTexel ImpostorRaster::texelAt(glm::ivec2 at) const
{
    std::array<const Sample*, kSamples * kSamples> covered{};
    int count = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const glm::ivec2 place = at * kSamples + glm::ivec2(i % kSamples, i / kSamples);
        const Sample& sample =
            (*m_shown)[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(m_size.x) +
                       static_cast<std::size_t>(place.x)];
        if (sample.triangle != kNothing) {
            covered[static_cast<std::size_t>(count++)] = &sample;
        }
    }
    if (count < kLeastCovered) {
        return {};
    }
    const auto isAlike = [this](const Sample& a, const Sample& b) {
        const Triangle& one = m_triangles[a.triangle];
        const Triangle& other = m_triangles[b.triangle];
        return one.slot == other.slot && one.part == other.part;
    };
    const std::span<const Sample*> seen(covered.data(), static_cast<std::size_t>(count));
    const Sample* chosen = nullptr;
    std::ptrdiff_t most = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        // From the middle outwards: of equals the first one stays.
        const Sample* one = seen[(i + seen.size() / 2) % seen.size()];
        const auto alike =
            std::ranges::count_if(seen, [&](const Sample* each) { return isAlike(*each, *one); });
        if (alike > most) {
            most = alike;
            chosen = one;
        }
    }
    glm::vec3 normal(0.0F);
    float depth = 0.0F;
    for (const Sample* each : seen) {
        if (isAlike(*each, *chosen)) {
            const Triangle& triangle = m_triangles[each->triangle];
            const glm::vec2 shares = each->shares;
            normal += m_normals[triangle.a] * (1.0F - shares.x - shares.y) +
                      m_normals[triangle.b] * shares.x + m_normals[triangle.c] * shares.y;
            depth += each->depth / static_cast<float>(most);
        }
    }
    return texelOf(*chosen, normal, depth);
}

ImpostorTexel ImpostorRaster::texelOf(const Sample& sample, const glm::vec3& normal,
                                      float depth) const
{
    const Mesh& mesh = m_asset.levels.front();
    const Triangle& triangle = m_triangles[sample.triangle];
    const auto mixed = [&](const auto& of) {
        return of(triangle.a) * (1.0F - sample.shares.x - sample.shares.y) +
               of(triangle.b) * sample.shares.x + of(triangle.c) * sample.shares.y;
    };
    const glm::vec2 uv =
        mixed([&](std::uint32_t v) { return v < mesh.uv.size() ? mesh.uv[v] : glm::vec2(0.0F); });
    const glm::vec3 color = mixed([&](std::uint32_t v) {
        return v < mesh.colors.size() ? glm::vec3(mesh.colors[v]) / 255.0F : glm::vec3(1.0F);
    });
    const glm::vec3 root = glm::sqrt(glm::max(color, 0.0F));
    ImpostorTexel texel;
    texel.surface = wrapped(uv.x) | wrapped(uv.y) << 8U |
                    static_cast<std::uint32_t>(octahedralEncode(normal)) << 16U;
    texel.kind = stepOf((m_layout.nearest - depth) / m_layout.depth, 255.0F) |
                 static_cast<std::uint32_t>(triangle.slot) << 8U |
                 static_cast<std::uint32_t>(triangle.part) << 14U | stepOf(root.x, 15.0F) << 20U |
                 stepOf(root.y, 15.0F) << 24U | stepOf(root.z, 15.0F) << 28U;
    return texel;
}

} // namespace crowd::model
