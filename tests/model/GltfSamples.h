// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "tests/model/GltfBuilder.h"
#include "tests/model/Near.h"

/// Small glTF files that several tests begin with, and what they show.
namespace gltf_samples {

using crowd::testing::near;
using Json = GltfBuilder::Json;

inline Json& primitive(GltfBuilder& builder)
{
    return builder.root["meshes"][0]["primitives"][0];
}

/// A triangle that follows two joints, one metre apart, one vertex each and one both.
inline GltfBuilder skinned()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int joints = builder.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    const int weights = builder.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0}, "VEC4");
    primitive(builder)["attributes"]["JOINTS_0"] = joints;
    primitive(builder)["attributes"]["WEIGHTS_0"] = weights;
    builder.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}},
                             {{"name", "hips"}, {"children", {2}}},
                             {{"name", "head"}, {"translation", {0, 1, 0}}}};
    builder.root["scenes"][0]["nodes"] = {0, 1};
    builder.add("skins", {{"joints", {1, 2}}});
    return builder;
}

/// Appends a clip of one channel: three floats a key, or four for rotations.
inline void animate(GltfBuilder& builder, const Json& clip, int node, const char* path,
                    const std::vector<float>& times, const std::vector<float>& values)
{
    const int input = builder.accessor(times, "SCALAR");
    const int output = builder.accessor(values, std::string(path) == "rotation" ? "VEC4" : "VEC3");
    Json animation = clip;
    animation["samplers"] = {{{"input", input}, {"output", output}}};
    animation["channels"] = {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}};
    builder.add("animations", animation);
}

/// A little of everything that the importer reads, without pictures and compression: a file to
/// damage.
inline GltfBuilder everything()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "nod"}, {"extras", {{"speed", 1.5}, {"seatHeight", 0.4}}}}, 2,
            "rotation", {0, 0.25F, 1}, {0, 0, 0, 1, 0, 0.5F, 0, 0.5F, 0, 0, 0, 1});
    animate(builder, {{"name", "hop"}}, 1, "translation", {0, 1},
            {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    builder.root["animations"][1]["samplers"][0]["interpolation"] = "CUBICSPLINE";
    Json& attributes = primitive(builder)["attributes"];
    attributes["COLOR_0"] =
        builder.accessor<std::uint8_t>({9, 9, 9, 9, 99, 9, 9, 9, 255, 9, 9, 9}, "VEC4");
    builder.root["accessors"].back()["normalized"] = true;
    attributes["TEXCOORD_1"] = builder.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
    const int morph = builder.accessorOf(-1, 5126, 3, "VEC3");
    const int at = builder.view<std::uint8_t>({1});
    const int values = builder.view<float>({0, 0, 4});
    builder.root["accessors"][static_cast<std::size_t>(morph)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", at}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    primitive(builder)["targets"] = {{{"POSITION", morph}}};
    primitive(builder)["material"] = 0;
    primitive(builder)["extensions"]["KHR_materials_variants"] = {
        {"mappings", {{{"material", 1}, {"variants", {0}}}}}};
    builder.root["meshes"][0]["weights"] = {0.25};
    builder.root["extensions"]["KHR_materials_variants"] = {{"variants", {{{"name", "night"}}}}};
    builder.add("images", {{"uri", "data:image/png;base64,AAAA"}});
    builder.add("samplers", {{"wrapS", 33071}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
    const Json transform = {{"KHR_texture_transform", {{"scale", {2, 3}}, {"texCoord", 1}}}};
    builder.add("materials", {{"pbrMetallicRoughness",
                               {{"baseColorTexture", {{"index", 0}, {"extensions", transform}}}}},
                              {"extras", {{"slot", "top"}, {"tintMask", 0}}}});
    builder.add("materials", {{"alphaMode", "MASK"}, {"emissiveFactor", {1, 0, 0}}});
    const Json strip = {{"attributes", {{"POSITION", attributes["POSITION"]}}}, {"mode", 5}};
    const int tree = builder.add("meshes", {{"primitives", {strip, strip}}});
    const int places = builder.accessor<float>({0, 0, 0, 5, 0, 0}, "VEC3");
    const Json instances = {
        {"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}};
    builder.add("nodes", {{"mesh", tree}, {"extensions", instances}});
    builder.add("nodes", {{"mesh", tree}, {"name", "hat_LOD0"}, {"scale", {-1, 2, 1}}});
    builder.add("nodes", {{"mesh", tree}, {"name", "hat_LOD1"}});
    builder.root["nodes"][3]["extensions"]["MSFT_lod"] = {{"ids", {5}}};
    builder.root["nodes"][2]["children"] = {4};
    const Json seat = {{"position", {1, 2, 3}}, {"headingRadians", 1}, {"height", 0.4}};
    builder.root["scenes"][0] = {{"nodes", {0, 1, 3}}, {"extras", {{"seats", {seat, seat}}}}};
    return builder;
}

/// The deformed vertices; a clip of -1 is the resting pose.
inline std::vector<glm::vec3> posed(const crowd::model::Template& asset, int clip, float seconds,
                                    std::size_t level = 0)
{
    crowd::model::Pose pose;
    crowd::model::evaluatePose(asset, clip, seconds, pose);
    std::vector<glm::vec3> positions(asset.levels[level].positions.size());
    crowd::model::skin(asset.levels[level], pose.bones, positions, {});
    return positions;
}

} // namespace gltf_samples
