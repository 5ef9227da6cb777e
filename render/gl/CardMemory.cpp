// SPDX-License-Identifier: MIT
#include "render/gl/CardMemory.h"

#include <atomic>
#include <utility>

#include <epoxy/gl.h>

namespace crowd::render::card_memory {

namespace {

std::atomic<std::int64_t> taken{0};
std::atomic<std::int64_t> limit{kNoLimit};
thread_local bool wasRefused = false;
thread_local bool wasAsked = false; ///< so that the driver is not waited for without need

} // namespace

std::int64_t bytes()
{
    return taken;
}

void limitTo(std::int64_t bytes)
{
    limit = bytes;
}

bool take(std::size_t bytes)
{
    const auto more = static_cast<std::int64_t>(bytes);
    if ((taken += more) > limit) {
        taken -= more;
        wasRefused = true;
        return false;
    }
    wasAsked = true;
    return true;
}

void giveBack(std::size_t bytes)
{
    taken -= static_cast<std::int64_t>(bytes);
}

bool wasShort()
{
    bool isShort = std::exchange(wasRefused, false);
    if (std::exchange(wasAsked, false)) {
        // Every kind of error is said once; a context that is gone says the same for ever.
        constexpr int kKinds = 8;
        for (int i = 0; i < kKinds; ++i) {
            const GLenum error = glGetError();
            if (error == GL_NO_ERROR) {
                break;
            }
            isShort = isShort || error == GL_OUT_OF_MEMORY;
        }
    }
    return isShort;
}

} // namespace crowd::render::card_memory
