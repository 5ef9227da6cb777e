// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "model/base/Result.h"
#include "model/gltf/GltfContainer.h"

namespace crowd::model::gltf {

/// What a program that we wait for may take. Its memory is for the program itself to limit.
struct ApartLimits
{
    std::uint64_t outputBytes = 0;
    int milliseconds = 0;
};

/// Where a program of ours is: beside the running program or above it (as for tests), or beside or
/// above the library that this code is in (as for the Python module). Empty if it is nowhere.
[[nodiscard]] std::string besideProgram(const std::string& name);

/// Runs `program` with `input` on its standard input, and brings home what it writes to its
/// standard output. For decoders that are not to be trusted with hostile data: if it crashes, hangs
/// or says too much, that is an Error that tells which. On any thread; it blocks.
Result<Bytes> runApart(const std::string& program, const Bytes& input, const ApartLimits& limits);

} // namespace crowd::model::gltf
