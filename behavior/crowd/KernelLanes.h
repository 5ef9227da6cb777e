// SPDX-License-Identifier: MIT
// Eight floats at a time: what the force kernel is written in. Part of ForceKernelBody.h and, like
// it, compiled once for each instruction set.

using F8 = float __attribute__((vector_size(32)));
using I8 = std::int32_t __attribute__((vector_size(32)));
using F4 = float __attribute__((vector_size(16)));
/// Vectors in memory lie anywhere. Said of the name: clang leaves out what is said of the type.
using I8InMemory __attribute__((vector_size(32), aligned(4), may_alias)) = std::int32_t;
using F8InMemory __attribute__((vector_size(32), aligned(4), may_alias)) = float;
using F4InMemory __attribute__((vector_size(16), aligned(4), may_alias)) = float;

#define CROWD_INLINE [[gnu::always_inline]] inline

CROWD_INLINE F8 load(const float* from)
{
    return *reinterpret_cast<const F8InMemory*>(from);
}

CROWD_INLINE void store(float* to, F8 value)
{
    *reinterpret_cast<F8InMemory*>(to) = value;
}

CROWD_INLINE F4 loadFour(const float* from)
{
    return *reinterpret_cast<const F4InMemory*>(from);
}

CROWD_INLINE F8 join(F4 low, F4 high)
{
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

CROWD_INLINE F8 all(float value)
{
    return F8{} + value;
}

CROWD_INLINE F8 squaredDistances(const F8& x, const F8& z)
{
    return x * x + z * z;
}

#ifdef CROWD_KERNEL_AVX2

CROWD_INLINE F8 greater(F8 a, F8 b)
{
    return _mm256_max_ps(a, b);
}

CROWD_INLINE F8 lesser(F8 a, F8 b)
{
    return _mm256_min_ps(a, b);
}

CROWD_INLINE F8 squareRoot(F8 a)
{
    return _mm256_sqrt_ps(a);
}

/// Bit l: lane l of a is less than that of b.
CROWD_INLINE unsigned bitsWhereLess(F8 a, F8 b)
{
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
}

/// Writes `first` plus the numbers of the bits that are set, ascending; what follows is spoilt.
CROWD_INLINE void listBits(unsigned bits, std::uint32_t first, std::uint32_t* to)
{
    const __m256i order = _mm256_cvtepu8_epi32(
        _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&kPackOrders.lanes[bits])));
    *reinterpret_cast<I8InMemory*>(to) =
        reinterpret_cast<I8>(order) + static_cast<std::int32_t>(first);
}

#else

CROWD_INLINE F8 greater(F8 a, F8 b)
{
    return a > b ? a : b;
}

CROWD_INLINE F8 lesser(F8 a, F8 b)
{
    return a < b ? a : b;
}

CROWD_INLINE F8 squareRoot(F8 a)
{
    F8 root;
    for (std::size_t l = 0; l < kLanes; ++l) {
        root[l] = std::sqrt(a[l]);
    }
    return root;
}

CROWD_INLINE unsigned bitsWhereLess(F8 a, F8 b)
{
    unsigned bits = 0;
    for (std::size_t l = 0; l < kLanes; ++l) {
        bits |= a[l] < b[l] ? 1U << l : 0U;
    }
    return bits;
}

CROWD_INLINE void listBits(unsigned bits, std::uint32_t first, std::uint32_t* to)
{
    for (; bits != 0; bits &= bits - 1) {
        *to++ = first + static_cast<std::uint32_t>(std::countr_zero(bits));
    }
}

#endif

/// Eight records of eight floats each become eight columns, or the other way round.
CROWD_INLINE void transpose(const float* const (&records)[kLanes], F8 (&columns)[kLanes])
{
    F8 half[kLanes]; // the first four floats of two records each, then the last four
    for (std::size_t i = 0; i < 4; ++i) {
        half[i] = join(loadFour(records[i]), loadFour(records[i + 4]));
        half[i + 4] = join(loadFour(records[i] + 4), loadFour(records[i + 4] + 4));
    }
    for (std::size_t i = 0; i < kLanes; i += 4) {
        const F8 low01 = __builtin_shufflevector(half[i], half[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        const F8 high01 = __builtin_shufflevector(half[i], half[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
        const F8 low23 =
            __builtin_shufflevector(half[i + 2], half[i + 3], 0, 8, 1, 9, 4, 12, 5, 13);
        const F8 high23 =
            __builtin_shufflevector(half[i + 2], half[i + 3], 2, 10, 3, 11, 6, 14, 7, 15);
        columns[i] = __builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13);
        columns[i + 1] = __builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15);
        columns[i + 2] = __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13);
        columns[i + 3] = __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15);
    }
}

/// As fastExp().
CROWD_INLINE F8 exponential(F8 x)
{
    const F8 power = greater(x * 1.44269504F, all(-126.0F));
    const I8 whole = __builtin_convertvector(power - 0.5F, I8);
    const F8 f = power - __builtin_convertvector(whole, F8);
    const F8 square = f * f;
    const F8 series =
        (1.0F + f * 0.693147181F) + square * ((0.240226507F + f * 0.0555041087F) +
                                              square * (0.00961812911F + f * 0.00133335581F));
    return series * reinterpret_cast<F8>((whole + 127) << 23);
}

/// Sums over the lanes of four vectors.
CROWD_INLINE F4 sumsOf(F8 a, F8 b, F8 c, F8 d)
{
    const auto fold = [](F8 v) __attribute__((always_inline))
    {
        return __builtin_shufflevector(v, v, 0, 1, 2, 3) +
               __builtin_shufflevector(v, v, 4, 5, 6, 7);
    };
    const F4 a4 = fold(a);
    const F4 b4 = fold(b);
    const F4 c4 = fold(c);
    const F4 d4 = fold(d);
    const F4 ab =
        __builtin_shufflevector(a4, b4, 0, 4, 1, 5) + __builtin_shufflevector(a4, b4, 2, 6, 3, 7);
    const F4 cd =
        __builtin_shufflevector(c4, d4, 0, 4, 1, 5) + __builtin_shufflevector(c4, d4, 2, 6, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
           __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

CROWD_INLINE float leastOf(F8 v)
{
    const F8 four = lesser(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    const F8 two = lesser(four, __builtin_shufflevector(four, four, 2, 3, 0, 1, 6, 7, 4, 5));
    return std::min(two[0], two[1]);
}
