// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// What the editor and crowdbrush-unpack say to each other, in words of four bytes of this machine.
///
/// Request, on standard input: kMagic, the number of meshes, then for each mesh its JobHead, an
/// AttributeHead for each attribute, and the compressed bytes.
/// Answer, on standard output: for each mesh a MeshHead, the corners of its triangles (four bytes
/// each), then the values of attribute after attribute. It ends after the first mesh that is not
/// Outcome::Fine, of which there is only the head.
namespace crowd::model::unpack {

inline constexpr std::uint32_t kMagic = 0x44574243; // "CBWD"
inline constexpr const char* kProgram = "crowdbrush-unpack";

struct JobHead
{
    std::uint32_t bytes = 0;
    std::uint32_t maxPoints = 0;
    std::uint32_t maxCorners = 0;
    std::uint32_t attributes = 0;
};

struct AttributeHead
{
    std::uint32_t id = 0;            ///< Draco's unique id
    std::uint32_t componentType = 0; ///< glTF's number of it
    std::uint32_t components = 0;    ///< 1 to 4
};

enum class Outcome : std::uint32_t { Fine, Damaged, TooManyPoints, TooManyCorners, NoAttribute };

struct MeshHead
{
    Outcome outcome = Outcome::Damaged;
    std::uint32_t points = 0;
    std::uint32_t corners = 0;
};

} // namespace crowd::model::unpack
