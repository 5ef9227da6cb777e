// SPDX-License-Identifier: MIT
#include "render/gl/SoftwareTuning.h"

#include <cstring>

#include <epoxy/gl.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace crowd::render {

bool isSoftwareRenderer()
{
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name != nullptr &&
           (std::strstr(name, "llvmpipe") != nullptr || std::strstr(name, "softpipe") != nullptr);
}

void tuneForSoftwareRendering()
{
#ifdef __GLIBC__
    constexpr int kBytesKept = 512 << 20;
    mallopt(M_TRIM_THRESHOLD, kBytesKept);
    mallopt(M_MMAP_THRESHOLD, kBytesKept);
#endif
}

} // namespace crowd::render
