#pragma once

#include "app/render/gl_objects.h"
#include "app/render/image.h"

namespace tractus::render {

// Render target of the renderer: an off-screen framebuffer with four samples per pixel.
class Canvas {
public:
    // `width` and `height` are in pixels, at least 1.
    Canvas(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Binds this canvas as the framebuffer. It receives all drawing until another one is bound.
    void bind() const;

    // Averages the samples of each pixel. Call this after drawing and before texture() or image().
    void resolve() const;

    // Returns the resolved picture as a texture, with rows from bottom to top. Valid as long as the
    // canvas.
    GLuint texture() const { return texture_.name(); }

    // Returns the resolved picture as an image in memory.
    Image image() const;

private:
    int width_ = 0;
    int height_ = 0;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer samples_;
    gl::Texture texture_;
    gl::Framebuffer resolved_;
};

} // namespace tractus::render
