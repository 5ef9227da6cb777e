// SPDX-License-Identifier: MIT
#include "behavior/session/PackKernel.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "behavior/crowd/Avx2.h"

#ifdef CROWD_HAS_AVX2
#include <immintrin.h>
#endif

namespace crowd::behavior {

namespace {

using Word = std::uint32_t;

constexpr std::size_t kWordBytes = sizeof(Word);

/// As many of its bytes as are needed.
unsigned codeOf(Word word)
{
    return static_cast<unsigned>(word > 0) + static_cast<unsigned>(word > 0xFFFFU) +
           static_cast<unsigned>(word > 0xFFFFFFU);
}

PackPlaces packPlainly(PackPlaces to, const std::byte* now, const std::byte* before,
                       std::size_t groups)
{
    for (std::size_t at = 0; at < groups * kPackedGroupBytes; at += kPackedGroupBytes) {
        std::array<Word, kPackedWords> words{};
        std::memcpy(words.data(), now + at, kPackedGroupBytes);
        if (before != nullptr) {
            std::array<Word, kPackedWords> then{};
            std::memcpy(then.data(), before + at, kPackedGroupBytes);
            for (std::size_t i = 0; i < kPackedWords; ++i) {
                words[i] ^= then[i];
            }
        }
        unsigned codes = 0;
        for (unsigned i = 0; i < kPackedWords; ++i) {
            const unsigned code = codeOf(words[i]);
            codes |= code << (2 * i);
            std::memcpy(to.data, &words[i], kWordBytes); // what is too much is written over
            to.data += packedLength(code);
        }
        *to.codes++ = static_cast<std::byte>(codes);
    }
    return to;
}

#ifdef CROWD_HAS_AVX2

constexpr std::size_t kAllCodes = 256; ///< of a group

/// For the codes of a group: which of its bytes follow, and how many those are.
struct Shuffles
{
    alignas(kPackedGroupBytes)
        std::array<std::array<std::uint8_t, kPackedGroupBytes>, kAllCodes> bytes{};
    std::array<std::uint8_t, kAllCodes> lengths{};
};

constexpr Shuffles makeShuffles()
{
    Shuffles all;
    for (unsigned codes = 0; codes < kAllCodes; ++codes) {
        std::size_t to = 0;
        for (unsigned i = 0; i < kPackedWords; ++i) {
            const std::size_t length = packedLength(codes >> (2 * i) & 3U);
            for (std::size_t byte = 0; byte < length; ++byte) {
                all.bytes[codes][to++] = static_cast<std::uint8_t>(kWordBytes * i + byte);
            }
        }
        all.lengths[codes] = static_cast<std::uint8_t>(to);
        for (; to < kPackedGroupBytes; ++to) {
            all.bytes[codes][to] = 0x80; // a zero
        }
    }
    return all;
}

constexpr Shuffles kShuffles = makeShuffles();

__attribute__((target("avx2"))) PackPlaces packWithAvx2(PackPlaces to, const std::byte* now,
                                                        const std::byte* before, std::size_t groups)
{
    const __m128i zero = _mm_setzero_si128();
    const __m128i three = _mm_set1_epi32(3);
    for (std::size_t i = 0; i < groups; ++i) {
        const std::size_t at = i * kPackedGroupBytes;
        __m128i words = _mm_loadu_si128(reinterpret_cast<const __m128i*>(now + at));
        if (before != nullptr) {
            words = _mm_xor_si128(words,
                                  _mm_loadu_si128(reinterpret_cast<const __m128i*>(before + at)));
        }
        // A word's code is three, less one for each bound that it is not above.
        const __m128i bounds =
            _mm_add_epi32(_mm_add_epi32(_mm_cmpeq_epi32(words, zero),
                                        _mm_cmpeq_epi32(_mm_srli_epi32(words, 16), zero)),
                          _mm_cmpeq_epi32(_mm_srli_epi32(words, 24), zero));
        const __m128i codes = _mm_add_epi32(bounds, three);
        const __m128i bytes = _mm_packus_epi16(_mm_packs_epi32(codes, zero), zero);
        // The two bits of each of the four bytes, side by side in the highest.
        constexpr std::uint32_t kGather = 1U << 24U | 1U << 18U | 1U << 12U | 1U << 6U;
        const auto four = static_cast<std::uint32_t>(_mm_cvtsi128_si32(bytes));
        const std::uint32_t group = four * kGather >> 24U;
        const __m128i order =
            _mm_load_si128(reinterpret_cast<const __m128i*>(kShuffles.bytes[group].data()));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to.data), _mm_shuffle_epi8(words, order));
        to.data += kShuffles.lengths[group];
        *to.codes++ = static_cast<std::byte>(group);
    }
    return to;
}

#endif

} // namespace

PackPlaces packGroups(PackPlaces to, const std::byte* now, const std::byte* before,
                      std::size_t groups, [[maybe_unused]] bool isPlain)
{
#ifdef CROWD_HAS_AVX2
    if (hasAvx2() && !isPlain) {
        return packWithAvx2(to, now, before, groups);
    }
#endif
    return packPlainly(to, now, before, groups);
}

} // namespace crowd::behavior
