// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// What an import may take, so that a hostile file cannot exhaust the machine. All far above what a
/// crowd's template or a stage needs.
namespace crowd::model::gltf {

inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 30U;
/// All buffers of a file together, decompressed ones included.
inline constexpr std::uint64_t kMaxBufferBytes = std::uint64_t{1} << 30U;
inline constexpr int kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxJsonValues = std::size_t{1} << 22U;
inline constexpr std::uint64_t kMaxAccessorElements = std::uint64_t{1} << 25U;
/// Elements times components.
inline constexpr std::uint64_t kMaxAccessorNumbers = std::uint64_t{1} << 26U;
/// Emitted vertices and triangle corners, after nodes that share a mesh are expanded.
inline constexpr std::uint64_t kMaxVertices = std::uint64_t{1} << 23U;
inline constexpr std::uint64_t kMaxCorners = std::uint64_t{3} << 23U;
/// Primitives drawn, after nodes that share a mesh are expanded.
inline constexpr std::uint64_t kMaxPrimitives = std::uint64_t{1} << 20U;
/// Vertices of all morph targets, expanded likewise.
inline constexpr std::uint64_t kMaxMorphed = std::uint64_t{1} << 27U;
inline constexpr std::size_t kMaxItems = 1U << 18U; ///< nodes, accessors, … of each kind
inline constexpr std::size_t kMaxBones = 65535;
inline constexpr std::uint64_t kMaxAnimationFloats = std::uint64_t{1} << 27U;
inline constexpr float kMaxClipSeconds = 3600.0F;
/// All pictures together, as they are in the file.
inline constexpr std::uint64_t kMaxEncodedBytes = std::uint64_t{1} << 29U;
inline constexpr int kMaxImageSide = 16384;
inline constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 27U; ///< all images together

} // namespace crowd::model::gltf
