// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "model/base/Result.h"

namespace crowd::render {

/// A GL context without a window or a display: EGL on a device, hardware first, Mesa's software
/// rasteriser last. Has no framebuffer of its own. Lives on the thread that made it; other contexts
/// may become current in between.
class OffscreenContext
{
public:
    enum class Profile : std::uint8_t { Core33, Compatibility };

    /// Made and current on success.
    [[nodiscard]] static model::Result<std::unique_ptr<OffscreenContext>>
    create(Profile profile = Profile::Core33);
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    [[nodiscard]] bool makeCurrent();
    void doneCurrent();

private:
    OffscreenContext() = default;

    void* m_display = nullptr;
    void* m_context = nullptr;
};

} // namespace crowd::render
