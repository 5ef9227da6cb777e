// SPDX-License-Identifier: MIT
#include "render/reference/SyntheticPerson.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace crowd::render {

namespace {

using namespace model;

constexpr float kTau = 6.2831853F;
constexpr std::array<float, kMaxLevels> kShares{1.0F, 0.44F, 0.26F, 0.11F};

struct Limb
{
    const char* name;
    glm::vec3 joint; ///< where it turns
    glm::vec3 center;
    glm::vec3 radii;
    int slot;
    float swing; ///< radians about X, in the walk
};

constexpr int kSkin = 0;
constexpr int kHair = 1;
constexpr int kTop = 2;
constexpr int kBottom = 3;
constexpr int kShoes = 4;

const std::array<Limb, 11>& limbs()
{
    static const std::array<Limb, 11> all{{
        {"head", {0, 1.5F, 0}, {0, 1.64F, 0}, {0.09F, 0.13F, 0.11F}, kSkin, 0.05F},
        {"hair", {0, 1.5F, 0}, {0, 1.69F, -0.02F}, {0.10F, 0.10F, 0.11F}, kHair, 0.05F},
        {"chest", {0, 1.0F, 0}, {0, 1.28F, 0}, {0.20F, 0.27F, 0.13F}, kTop, 0.03F},
        {"hips", {0, 1.0F, 0}, {0, 0.95F, 0}, {0.17F, 0.16F, 0.13F}, kBottom, 0.0F},
        {"left arm", {0.22F, 1.42F, 0}, {0.25F, 1.15F, 0}, {0.05F, 0.30F, 0.05F}, kTop, -0.5F},
        {"right arm", {-0.22F, 1.42F, 0}, {-0.25F, 1.15F, 0}, {0.05F, 0.30F, 0.05F}, kTop, 0.5F},
        {"left hand", {0.22F, 1.42F, 0}, {0.25F, 0.82F, 0}, {0.04F, 0.09F, 0.04F}, kSkin, -0.5F},
        {"right hand", {-0.22F, 1.42F, 0}, {-0.25F, 0.82F, 0}, {0.04F, 0.09F, 0.04F}, kSkin, 0.5F},
        {"left leg", {0.1F, 0.92F, 0}, {0.1F, 0.47F, 0}, {0.08F, 0.46F, 0.08F}, kBottom, 0.45F},
        {"right leg", {-0.1F, 0.92F, 0}, {-0.1F, 0.47F, 0}, {0.08F, 0.46F, 0.08F}, kBottom, -0.45F},
        {"left shoe", {0.1F, 0.92F, 0}, {0.1F, 0.05F, 0.05F}, {0.06F, 0.05F, 0.13F}, kShoes, 0.45F},
    }};
    return all;
}

/// Rings and segments of an ellipsoid with about `triangles` triangles.
struct Tessellation
{
    int segments;
    int rings;
};

Tessellation tessellationFor(int triangles)
{
    const int rings = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 2.4))));
    return {std::max(3, triangles / (2 * (rings - 1))), rings};
}

void addEllipsoid(Mesh& mesh, const Limb& limb, std::uint16_t bone, const Tessellation& grid)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    Submesh submesh{limb.slot, -1, static_cast<std::uint32_t>(mesh.indices.size()), 0};
    for (int ring = 0; ring <= grid.rings; ++ring) {
        for (int segment = 0; segment <= grid.segments; ++segment) {
            const float u = static_cast<float>(segment) / static_cast<float>(grid.segments);
            const float v = static_cast<float>(ring) / static_cast<float>(grid.rings);
            const float polar = v * kTau * 0.5F;
            const glm::vec3 unit(std::sin(polar) * std::sin(u * kTau), std::cos(polar),
                                 std::sin(polar) * std::cos(u * kTau));
            mesh.positions.push_back(limb.center + unit * limb.radii);
            mesh.normals.push_back(glm::normalize(unit / limb.radii));
            mesh.uv.emplace_back(u, v);
            mesh.colors.emplace_back(255, 255, 255, 255);
            mesh.bones.push_back(bone);
            mesh.weights.push_back(1.0F);
        }
    }
    const auto row = static_cast<std::uint32_t>(grid.segments + 1);
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(grid.rings); ++ring) {
        for (std::uint32_t segment = 0; segment + 1 < row; ++segment) {
            const std::uint32_t a = first + ring * row + segment;
            const std::uint32_t b = a + row;
            if (ring > 0) {
                mesh.indices.insert(mesh.indices.end(), {a, b, a + 1});
            }
            if (ring + 1 < static_cast<std::uint32_t>(grid.rings)) {
                mesh.indices.insert(mesh.indices.end(), {a + 1, b, b + 1});
            }
        }
    }
    submesh.indexCount = static_cast<std::uint32_t>(mesh.indices.size()) - submesh.firstIndex;
    mesh.submeshes.push_back(submesh);
}

Mesh makeLevel(int triangles)
{
    Mesh mesh;
    const Tessellation grid = tessellationFor(triangles / static_cast<int>(limbs().size()));
    for (std::size_t i = 0; i < limbs().size(); ++i) {
        addEllipsoid(mesh, limbs()[i], static_cast<std::uint16_t>(i), grid);
    }
    return mesh;
}

/// Every limb swings about its joint; `share` of the walk's angles, `lift` added.
Clip makeClip(const char* name, float seconds, float share, float lift)
{
    constexpr int kKeys = 9;
    Clip clip;
    clip.name = name;
    clip.seconds = seconds;
    for (std::size_t i = 0; i < limbs().size(); ++i) {
        Channel channel;
        channel.node = static_cast<int>(i);
        channel.path = ChannelPath::Rotation;
        const bool isArm = limbs()[i].joint.x != 0.0F && limbs()[i].joint.y > 1.0F;
        for (int key = 0; key < kKeys; ++key) {
            const float place = static_cast<float>(key) / static_cast<float>(kKeys - 1);
            const float angle =
                limbs()[i].swing * share * std::sin(place * kTau) - (isArm ? lift : 0.0F);
            channel.times.push_back(place * seconds);
            channel.values.insert(channel.values.end(),
                                  {std::sin(angle * 0.5F), 0.0F, 0.0F, std::cos(angle * 0.5F)});
        }
        clip.channels.push_back(std::move(channel));
    }
    return clip;
}

Image makeCloth()
{
    constexpr int kSize = 128;
    Image image{"cloth", kSize, kSize, {}};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const bool isStripe = (y / 8) % 2 == 0;
            const auto shade = static_cast<std::uint8_t>((isStripe ? 235 : 190) + (x * 7 + y) % 20);
            image.rgba.insert(image.rgba.end(), {shade, shade, shade, 255});
        }
    }
    return image;
}

Slot makeSlot(const char* name, const glm::vec3& color, int image = -1)
{
    MaterialChoice choice;
    choice.name = name;
    choice.baseColor = glm::vec4(color, 1.0F);
    choice.image = image;
    return {name, true, true, {choice}};
}

} // namespace

std::shared_ptr<Template> makeSyntheticPerson(int triangles)
{
    auto asset = std::make_shared<Template>();
    asset->name = "figure of " + std::to_string(triangles) + " triangles";
    for (std::size_t i = 0; i < limbs().size(); ++i) {
        Node& node = asset->nodes.emplace_back();
        node.name = limbs()[i].name;
        node.translation = limbs()[i].joint;
        asset->bones.push_back(
            {static_cast<int>(i), glm::translate(glm::mat4(1.0F), -limbs()[i].joint)});
    }
    for (const float share : kShares) {
        asset->levels.push_back(makeLevel(static_cast<int>(static_cast<float>(triangles) * share)));
    }
    asset->slots = {makeSlot("skin", {0.6F, 0.4F, 0.3F}), makeSlot("hair", {0.1F, 0.07F, 0.05F}),
                    makeSlot("top", {0.8F, 0.8F, 0.8F}, 0), makeSlot("bottom", {0.3F, 0.3F, 0.4F}),
                    makeSlot("shoes", {0.1F, 0.1F, 0.1F})};
    asset->slots[kSkin].tintable = false;
    asset->images = {makeCloth()};
    asset->clips = {makeClip("walk", 1.0F, 1.0F, 0.0F), makeClip("cheer", 1.5F, 0.3F, 2.6F),
                    makeClip("idle", 2.0F, 0.1F, 0.0F)};
    asset->defaultClip = 2;
    asset->bounds.add(glm::vec3(-0.3F, 0.0F, -0.2F));
    asset->bounds.add(glm::vec3(0.3F, 1.79F, 0.2F));
    asset->height = 1.79F;
    return asset;
}

} // namespace crowd::render
