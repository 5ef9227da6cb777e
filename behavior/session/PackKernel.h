// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crowd::behavior {

inline constexpr std::size_t kPackedWords = 4; ///< that one byte of codes is for
inline constexpr std::size_t kPackedGroupBytes = 16;

/// Where codes of groups are written, and behind all of them their bytes. Handed on by value: a
/// compiler that must think of them as what is written to takes five times as long.
struct PackPlaces
{
    std::byte* codes;
    std::byte* data;
};

/// Packs groups of four words, or what differs in them from those before (null: none): two bits a
/// word say how many bytes of it follow, 0, 2, 3 or 4 (after D. Lemire et al., Stream VByte, 2018).
/// There is room for a group more than is written. The same bytes on every processor;
/// `isPlain`: without instructions that not all have, for tests.
[[nodiscard]] PackPlaces packGroups(PackPlaces to, const std::byte* now, const std::byte* before,
                                    std::size_t groups, bool isPlain = false);

/// Bytes that follow for a code.
[[nodiscard]] constexpr std::size_t packedLength(unsigned code)
{
    return code == 0 ? 0 : code + 1;
}

} // namespace crowd::behavior
