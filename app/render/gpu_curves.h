#pragma once

#include "app/render/curve.h"
#include "app/render/gl_objects.h"
#include "engine/plant/plant.h"

#include <span>

namespace tractus::render {

// Curves uploaded to the GPU. Create them once and draw them often. They must not outlive the
// OpenGL context.
class GpuCurves {
public:
    explicit GpuCurves(std::span<Curve const> curves);

    // Bounding box of all points of the curves; empty if there are no points.
    Bounds const& bounds() const { return bounds_; }

    // Draws each segment as a strip of four corners. The curve shader must be in use.
    void draw() const;

private:
    Bounds bounds_;
    GLsizei segment_count_ = 0;
    gl::Buffer segments_;
    gl::VertexArray vertex_array_;
};

} // namespace tractus::render
