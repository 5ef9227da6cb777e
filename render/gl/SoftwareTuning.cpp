// SPDX-License-Identifier: MIT
#include "render/gl/SoftwareTuning.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace crowd::render {

void tuneForSoftwareRendering()
{
#ifdef __GLIBC__
    constexpr int kBytesKept = 512 << 20;
    mallopt(M_TRIM_THRESHOLD, kBytesKept);
    mallopt(M_MMAP_THRESHOLD, kBytesKept);
#endif
}

} // namespace crowd::render
