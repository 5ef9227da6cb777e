// SPDX-License-Identifier: MIT
#include "render/OffscreenContext.h"

#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace crowd::render {

namespace {

bool hasClientExtension(const char* name)
{
    return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

bool isSoftware(EGLDeviceEXT device)
{
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") != nullptr;
}

/// Displays to try, hardware first, without initialising any.
std::vector<EGLDisplay> candidates()
{
    std::vector<EGLDisplay> hardware;
    std::vector<EGLDisplay> software;
    if (hasClientExtension("EGL_EXT_platform_device") &&
        hasClientExtension("EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 32> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
            EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
            (isSoftware(device) ? software : hardware).push_back(display);
        }
    }
    if (hasClientExtension("EGL_MESA_platform_surfaceless")) {
        software.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    }
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
}

EGLContext makeContext(EGLDisplay display, OffscreenContext::Profile profile)
{
    const std::array<EGLint, 7> core{EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    const std::array<EGLint, 3> compatibility{
        EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_NONE};
    const std::array<EGLint, 5> any{EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE,
                                    EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, any.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
        config = EGL_NO_CONFIG_KHR;
    }
    return eglCreateContext(display, config, EGL_NO_CONTEXT,
                            profile == OffscreenContext::Profile::Core33 ? core.data()
                                                                         : compatibility.data());
}

/// A current context on the display, or none.
EGLContext open(EGLDisplay display, OffscreenContext::Profile profile)
{
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
        !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
        eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        return EGL_NO_CONTEXT;
    }
    EGLContext context = makeContext(display, profile);
    if (context == EGL_NO_CONTEXT) {
        return EGL_NO_CONTEXT;
    }
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return context;
    }
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
}

} // namespace

model::Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create(Profile profile)
{
    const std::vector<EGLDisplay> displays = candidates();
    for (EGLDisplay display : displays) {
        EGLContext made = open(display, profile);
        if (made == EGL_NO_CONTEXT) {
            continue;
        }
        std::unique_ptr<OffscreenContext> context(new OffscreenContext());
        context->m_display = display;
        context->m_context = made;
        return context;
    }
    if (displays.empty()) {
        return model::Error{QT_TRANSLATE_NOOP(
            "Messages",
            "Pictures without a window need EGL with device or surfaceless displays, and this "
            "system's libEGL has neither. Install Mesa (packages libegl1 and libgl1-mesa-dri).")};
    }
    return model::Error{
        profile == Profile::Core33
            ? QT_TRANSLATE_NOOP(
                  "Messages",
                  "None of this system's %1 EGL displays gives a context for OpenGL 3.3. Install a "
                  "newer graphics driver, or Mesa's software one (package libgl1-mesa-dri).")
            : QT_TRANSLATE_NOOP("Messages",
                                "None of this system's %1 EGL displays gives a context for OpenGL "
                                "with display lists. Install a newer graphics driver, or Mesa's "
                                "software one (package libgl1-mesa-dri)."),
        displays.size()};
}

OffscreenContext::~OffscreenContext()
{
    doneCurrent();
    // The display is shared with every other context of the process and stays initialised.
    eglDestroyContext(m_display, m_context);
}

bool OffscreenContext::makeCurrent()
{
    return eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
           eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) == EGL_TRUE;
}

void OffscreenContext::doneCurrent()
{
    if (eglGetCurrentContext() == m_context) {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
}

} // namespace crowd::render
