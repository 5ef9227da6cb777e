// SPDX-License-Identifier: MIT
#include "model/base/Checksum.h"

#include <algorithm>
#include <cstring>

#include "model/base/Random.h"

namespace crowd::model {

namespace {

constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15U; ///< odd, without a pattern
constexpr std::size_t kWordBytes = sizeof(std::uint64_t);

std::uint64_t wordAt(std::span<const std::byte> bytes, std::size_t at)
{
    std::uint64_t word = 0;
    std::memcpy(&word, &bytes[at], kWordBytes);
    return word;
}

std::uint64_t added(std::uint64_t sum, std::uint64_t word)
{
    const std::uint64_t mixed = (sum ^ word) * kFactor;
    return mixed ^ (mixed >> 32U);
}

} // namespace

std::uint64_t checksumOf(std::span<const std::byte> bytes)
{
    // Four sums, which a processor multiplies at once. Each by its name: as a list, compilers make
    // one of vectors of them, which have no such product and take three times as long.
    std::uint64_t first = 1;
    std::uint64_t second = 2;
    std::uint64_t third = 3;
    std::uint64_t fourth = 4;
    std::size_t at = 0;
    for (; at + 4 * kWordBytes <= bytes.size(); at += 4 * kWordBytes) {
        first = added(first, wordAt(bytes, at));
        second = added(second, wordAt(bytes, at + kWordBytes));
        third = added(third, wordAt(bytes, at + 2 * kWordBytes));
        fourth = added(fourth, wordAt(bytes, at + 3 * kWordBytes));
    }
    std::uint64_t sum = bytes.size();
    for (const std::uint64_t each : {first, second, third, fourth}) {
        sum = mixBits(sum ^ each);
    }
    for (; at < bytes.size(); at += kWordBytes) {
        std::uint64_t rest = 0;
        std::memcpy(&rest, &bytes[at], std::min(kWordBytes, bytes.size() - at));
        sum = mixBits(sum ^ rest);
    }
    return sum;
}

} // namespace crowd::model
