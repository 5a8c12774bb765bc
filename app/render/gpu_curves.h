#pragma once

#include "app/render/curve.h"
#include "app/render/gl_objects.h"
#include "engine/plant/plant.h"

#include <span>

namespace tractus::render {

// Curves on the graphics card: made once, drawn many times. Lives and dies with the context.
class GpuCurves {
public:
    explicit GpuCurves(std::span<Curve const> curves);

    // The box around all points. Empty where there are none.
    Bounds const& bounds() const { return bounds_; }

    // Draws every segment as one strip of four corners; the curve shader is in use.
    void draw() const;

private:
    Bounds bounds_;
    GLsizei segment_count_ = 0;
    gl::Buffer segments_;
    gl::VertexArray vertex_array_;
};

} // namespace tractus::render
