// SPDX-License-Identifier: MIT
#pragma once

// GCC compiles kernels a second time for newer processors. (Not by function clones: the choice
// between those is made before a sanitizer is ready.)
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define CROWD_HAS_AVX2
#include <immintrin.h>

namespace crowd::behavior {

/// Whether this processor runs the copies in `with_avx2`, see KernelCopies.h.
inline bool hasAvx2()
{
    static const bool isThere = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2");
    return isThere;
}

} // namespace crowd::behavior
#endif
