// SPDX-License-Identifier: MIT
// pack_ground METHOD BITS: writes a hilly ground, compressed by Draco, to standard output. A
// program of its own, since libdraco brings a tinygltf that does not get on with the importer's.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include "tests/model/DracoGround.h"

namespace {

using Corner = std::array<int, 2>;

void addFace(draco::TriangleSoupMeshBuilder& builder, std::uint32_t face,
             const std::array<Corner, 3>& corners)
{
    std::array<std::array<float, 3>, 3> position{};
    std::array<std::array<std::uint8_t, 4>, 3> joint{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [x, z] = corners[i];
        position[i] = {static_cast<float>(x), draco_ground::height(x, z), static_cast<float>(z)};
        joint[i][0] = static_cast<std::uint8_t>(x % 2);
    }
    builder.SetAttributeValuesForFace(0, draco::FaceIndex(face), &position[0], &position[1],
                                      &position[2]);
    builder.SetAttributeValuesForFace(1, draco::FaceIndex(face), &joint[0], &joint[1], &joint[2]);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        return 2;
    }
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(draco_ground::kCorners / 3);
    builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
    std::uint32_t face = 0;
    for (int x = 0; x < draco_ground::kSide; ++x) {
        for (int z = 0; z < draco_ground::kSide; ++z) {
            addFace(builder, face++, {Corner{x, z}, {x, z + 1}, {x + 1, z}});
            addFace(builder, face++, {Corner{x + 1, z}, {x, z + 1}, {x + 1, z + 1}});
        }
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(std::atoi(argv[1]));
    if (const int bits = std::atoi(argv[2]); bits > 0) {
        encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    }
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) {
        return 1;
    }
    return std::fwrite(buffer.data(), 1, buffer.size(), stdout) == buffer.size() ? 0 : 1;
}
