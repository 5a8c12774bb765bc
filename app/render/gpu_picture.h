#pragma once

#include "app/render/gl_objects.h"
#include "app/render/image.h"

namespace tractus::render {

// A picture on the graphics card, smooth in any size. Lives and dies with the context.
class GpuPicture {
public:
    explicit GpuPicture(Image const& picture);

    GLuint texture() const { return texture_.name(); }

private:
    gl::Texture texture_;
};

} // namespace tractus::render
