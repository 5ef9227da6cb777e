// SPDX-License-Identifier: MIT
// CROWD_KERNEL_BODY, the name of a file, compiled once for each instruction set, in namespaces of
// their own: any_processor and, where Avx2.h says so, with_avx2. Included by a kernel once, inside
// its unnamed namespace: hence no include guard.

namespace any_processor {
#include CROWD_KERNEL_BODY
}

#ifdef CROWD_HAS_AVX2
#pragma GCC push_options
#pragma GCC target("avx2,bmi,bmi2,popcnt")
#define CROWD_KERNEL_AVX2
namespace with_avx2 {
#include CROWD_KERNEL_BODY
}
#pragma GCC pop_options
#endif
