#pragma once

#include "app/render/gl_objects.h"
#include "app/render/image.h"

namespace tractus::render {

// Surface that the renderer draws on: an off-screen picture with four samples to a pixel.
class Canvas {
public:
    // `width` and `height` are pixels, at least 1.
    Canvas(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Drawing goes here until another framebuffer is bound.
    void bind() const;

    // Joins the samples of each pixel: after drawing, before texture() or image() is used.
    void resolve() const;

    // The resolved picture as a texture, rows from bottom to top; it lives as long as the canvas.
    GLuint texture() const { return texture_.name(); }

    // The resolved picture as a value.
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
