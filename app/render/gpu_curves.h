#pragma once

#include "app/render/curve.h"
#include "app/render/gl_objects.h"
#include "engine/plant/plant.h"

#include <span>

namespace tractus::render {

// Curves uploaded to the GPU: created once, drawn many times. Must not outlive the OpenGL context.
class GpuCurves {
public:
    explicit GpuCurves(std::span<Curve const> curves);

    // Bounding box of all points; empty if there are none.
    Bounds const& bounds() const { return bounds_; }

    // Draws every segment as one strip of four corners. The curve shader must be in use.
    void draw() const;

private:
    Bounds bounds_;
    GLsizei segment_count_ = 0;
    gl::Buffer segments_;
    gl::VertexArray vertex_array_;
};

} // namespace tractus::render
