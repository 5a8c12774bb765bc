#pragma once

#include "engine/base/result.h"

#include <memory>

namespace tractus::render {

// An OpenGL 3.3 core context without window or display, current on the thread that made it until
// it is destroyed. It needs neither a graphics card nor a running display server: Mesa's software
// renderer will do.
class OffscreenContext {
public:
    // Fails, as the user's fault, where the system has no EGL or no OpenGL 3.3; the message names
    // the Debian packages that bring them.
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
