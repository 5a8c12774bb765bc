#include "app/render/offscreen_context.h"

#include <array>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>
#include <string_view>

namespace tractus::render {

struct OffscreenContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    // A buffer of pixels, created only on systems where a context requires a surface.
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    Handles() = default;
    Handles(Handles const&) = delete;
    Handles& operator=(Handles const&) = delete;

    ~Handles()
    {
        if (display == EGL_NO_DISPLAY)
            return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        if (surface != EGL_NO_SURFACE)
            eglDestroySurface(display, surface);
    }
};

namespace {

tl::unexpected<Error> no_context(std::string_view what)
{
    return fail(Fault::User,
                fmt::format("cannot draw off screen: {}; install Mesa's renderer "
                            "(Debian packages libegl1 and libgl1-mesa-dri)",
                            what));
}

EGLDisplay open_display()
{
    // EGL_MESA_platform_surfaceless provides a display without a window system.
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        auto* const display
            = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
            return display;
    }
    auto* const display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
        return display;
    return EGL_NO_DISPLAY;
}

EGLConfig choose_config(EGLDisplay display)
{
    constexpr std::array<EGLint, 5> kWanted { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                              EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, kWanted.data(), &config, 1, &count) || count == 0)
        return nullptr;
    return config;
}

bool make_current(EGLDisplay display, EGLContext context, EGLConfig config, EGLSurface& surface)
{
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        return true;
    // Without EGL_KHR_surfaceless_context, a context requires a surface. The smallest one is
    // enough, as everything is drawn into framebuffers that the program creates.
    constexpr std::array<EGLint, 5> kSmall { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    surface = eglCreatePbufferSurface(display, config, kSmall.data());
    return surface != EGL_NO_SURFACE && eglMakeCurrent(display, surface, surface, context);
}

} // namespace

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles)
    : handles_(std::move(handles))
{
}

OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;
OffscreenContext::~OffscreenContext() = default;

Result<OffscreenContext> OffscreenContext::create()
{
    if (!epoxy_has_egl())
        return no_context("the system has no EGL library");
    auto handles = std::make_unique<Handles>();
    handles->display = open_display();
    if (handles->display == EGL_NO_DISPLAY)
        return no_context("EGL offers no display without a window system");
    if (!eglBindAPI(EGL_OPENGL_API))
        return no_context("EGL here has no desktop OpenGL");
    auto* const config = choose_config(handles->display);
    constexpr std::array<EGLint, 7> kVersion { EGL_CONTEXT_MAJOR_VERSION,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               3,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE };
    handles->context = eglCreateContext(handles->display, config, EGL_NO_CONTEXT, kVersion.data());
    if (handles->context == EGL_NO_CONTEXT)
        return no_context(
            fmt::format("there is no OpenGL 3.3 core context (EGL error {:#x})", eglGetError()));
    if (!make_current(handles->display, handles->context, config, handles->surface))
        return no_context(
            fmt::format("the OpenGL context cannot be used (EGL error {:#x})", eglGetError()));
    return OffscreenContext(std::move(handles));
}

} // namespace tractus::render
