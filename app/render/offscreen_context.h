#pragma once

#include "engine/base/result.h"

#include <memory>

namespace tractus::render {

// An OpenGL 3.3 core context without a window or display. It is current on the thread that created
// it until it is destroyed. Mesa's software renderer suffices; neither a graphics card nor a
// display server is needed.
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
