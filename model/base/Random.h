// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace crowd::model {

/// Randomness without state: a value is a pure function of its keys (stroke seed, dab, individual,
/// purpose), so that no order of evaluation and no number of threads can change it.
/// The mixing function is the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t mixBits(std::uint64_t x)
{
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
}

/// 64 bits from any number of keys; the order of the keys matters.
template<class... Keys>
[[nodiscard]] constexpr std::uint64_t hashKeys(Keys... keys)
{
    std::uint64_t hash = 0;
    ((hash = mixBits(hash ^ static_cast<std::uint64_t>(keys))), ...);
    return hash;
}

/// A key from a name (FNV-1a, Fowler, Noll, Vo).
[[nodiscard]] constexpr std::uint64_t hashText(std::string_view text)
{
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char each : text) {
        hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001B3ULL;
    }
    return hash;
}

/// Uniform in [0, 1), 24 significant bits, exact on every machine.
[[nodiscard]] constexpr float unitFloat(std::uint64_t bits)
{
    return static_cast<float>(bits >> 40U) * (1.0F / 16777216.0F);
}

/// Uniform in [0, 1), 53 significant bits.
[[nodiscard]] constexpr double unitDouble(std::uint64_t bits)
{
    return static_cast<double>(bits >> 11U) * (1.0 / 9007199254740992.0);
}

} // namespace crowd::model
