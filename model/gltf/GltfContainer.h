// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/base/Result.h"

/// The outside of a glTF file: bytes on disk, the GLB envelope, and what URIs refer to.
namespace crowd::model::gltf {

using Bytes = std::vector<std::uint8_t>;

/// JSON text and, from a .glb, the binary chunk.
struct Container
{
    std::string json;
    Bytes binary;
    bool hasBinary = false;
    std::vector<Message> warnings;
};

/// Reads a file of at most kMaxFileBytes. The message names neither file nor way out.
Result<Bytes> readFile(const std::string& path);

/// Reads a .glb (glTF 2.0, section 4) or a .gltf, told apart by content. Other formats that the
/// artist may have (FBX, OBJ, Collada, Blender, USD, VRML, STL, PLY, X) are refused with the way
/// to convert them.
Result<Container> readContainer(const std::string& path);

/// The bytes behind a URI: "data:" with base64 or percent-encoding, or a relative path to a file
/// beside or below `folder` (no scheme, no "..", not absolute; percent-encoded UTF-8).
Result<Bytes> readUri(const std::string& uri, const std::string& folder);

} // namespace crowd::model::gltf
