#pragma once

#include "app/render/gl_objects.h"
#include "app/render/image.h"

namespace tractus::render {

// A picture uploaded to the GPU and filtered smoothly at any size. It must not outlive the OpenGL
// context.
class GpuPicture {
public:
    explicit GpuPicture(Image const& picture);

    GLuint texture() const { return texture_.name(); }

private:
    gl::Texture texture_;
};

} // namespace tractus::render
