// SPDX-License-Identifier: MIT
#include "model/base/Checksum.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "model/base/Random.h"

namespace crowd::model {

namespace {

constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15U; ///< odd, without a pattern
constexpr std::size_t kWordBytes = sizeof(std::uint64_t);
constexpr std::size_t kLanes = 4; ///< that a processor multiplies at once

} // namespace

std::uint64_t checksumOf(std::span<const std::byte> bytes)
{
    std::array<std::uint64_t, kLanes> sums{1, 2, 3, 4};
    std::array<std::uint64_t, kLanes> words{};
    std::size_t at = 0;
    for (; at + sizeof(words) <= bytes.size(); at += sizeof(words)) {
        std::memcpy(words.data(), &bytes[at], sizeof(words));
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::uint64_t mixed = (sums[lane] ^ words[lane]) * kFactor;
            sums[lane] = mixed ^ (mixed >> 32U);
        }
    }
    std::uint64_t sum = bytes.size();
    for (const std::uint64_t lane : sums) {
        sum = mixBits(sum ^ lane);
    }
    for (; at < bytes.size(); at += kWordBytes) {
        std::uint64_t rest = 0;
        std::memcpy(&rest, &bytes[at], std::min(kWordBytes, bytes.size() - at));
        sum = mixBits(sum ^ rest);
    }
    return sum;
}

} // namespace crowd::model
