#pragma once

#include "engine/base/result.h"

#include <memory>

namespace tractus::render {

// An OpenGL 3.3 core context without window or display, current on the creating thread until it is
// destroyed. It needs neither a graphics card nor a display server: Mesa's software renderer
// suffices.
class OffscreenContext {
public:
    // Fails with a user error if the system has no EGL or no OpenGL 3.3; the message names the
    // Debian packages to install.
    static Result<OffscreenContext> create();

    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;
    ~OffscreenContext();

private:
    struct Handles;
    explicit OffscreenContext(std::unique_ptr<Handles>);

    std::unique_ptr<Handles> handles_;
};

} // namespace tractus::render
