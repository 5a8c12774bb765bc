#include "app/render/gpu_curves.h"

#include <cstddef>

namespace tractus::render {

namespace {

// Data of one end of a segment, in the layout that the curve shader reads.
struct EndVertex {
    Vec3f position_mm = Vec3f::Zero();
    Vec3f color = Vec3f::Zero();
    float width = 0;
};

struct SegmentVertex {
    EndVertex begin {};
    EndVertex end {};
    // x: 1 if widths are in millimetres, otherwise 0. y: sum of kRound, kHead and kFades.
    Vec2f traits = Vec2f::Zero();
};

// Width of an arrow head's base, as a multiple of the line's width. kArrowLength is its length.
constexpr float kArrowWidth = 4.5f;
constexpr float kArrowLength = 7.0f;

// Flags of a segment; their sum is SegmentVertex::traits.y.
constexpr float kRound = 1;
constexpr float kHead = 2;
constexpr float kFades = 4;

EndVertex vertex(Curve::Point const& point)
{
    return { point.position_mm, point.color, point.width };
}

// Returns a cone beyond the last point. For widths in pixels the shader computes the cone's length,
// and the end stored here only gives the direction.
SegmentVertex arrow_head(Curve const& curve, Vec2f const& traits)
{
    auto const& last = curve.points.back();
    auto const& before = curve.points[curve.points.size() - 2];
    Vec3f const step = last.position_mm - before.position_mm;
    SegmentVertex head { vertex(last), vertex(last), traits + Vec2f(0, kHead) };
    head.begin.width = last.width * kArrowWidth;
    head.end.position_mm
        += traits.x() > 0 ? Vec3f(step.normalized() * (last.width * kArrowLength)) : step;
    head.end.width = 0;
    return head;
}

void add_segments(Curve const& curve, std::vector<SegmentVertex>& segments)
{
    Vec2f const traits(curve.width_unit == Curve::WidthUnit::Millimetres ? 1.0f : 0.0f,
                       (curve.look == Curve::Look::Round ? kRound : 0.0f)
                           + (curve.fades ? kFades : 0.0f));
    if (curve.points.size() == 1)
        segments.push_back({ vertex(curve.points[0]), vertex(curve.points[0]), traits });
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        segments.push_back({ vertex(curve.points[i - 1]), vertex(curve.points[i]), traits });
    if (curve.end == Curve::End::Arrow && curve.points.size() > 1)
        segments.push_back(arrow_head(curve, traits));
}

void point_attribute(GLuint index, GLint size, std::size_t offset_bytes)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(SegmentVertex),
                          gl::offset(offset_bytes));
    glVertexAttribDivisor(index, 1);
}

} // namespace

GpuCurves::GpuCurves(std::span<Curve const> curves)
{
    std::vector<SegmentVertex> segments;
    for (auto const& curve : curves) {
        add_segments(curve, segments);
        for (auto const& point : curve.points)
            bounds_.add(point.position_mm.cast<double>());
    }
    segment_count_ = static_cast<GLsizei>(segments.size());

    glBindVertexArray(vertex_array_.name());
    gl::upload(segments_, GL_ARRAY_BUFFER, std::span<SegmentVertex const>(segments));
    constexpr std::size_t kEnd = offsetof(SegmentVertex, end);
    point_attribute(0, 3, offsetof(EndVertex, position_mm));
    point_attribute(1, 3, offsetof(EndVertex, color));
    point_attribute(2, 1, offsetof(EndVertex, width));
    point_attribute(3, 3, kEnd + offsetof(EndVertex, position_mm));
    point_attribute(4, 3, kEnd + offsetof(EndVertex, color));
    point_attribute(5, 1, kEnd + offsetof(EndVertex, width));
    point_attribute(6, 2, offsetof(SegmentVertex, traits));
    glBindVertexArray(0);
}

void GpuCurves::draw() const
{
    glBindVertexArray(vertex_array_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segment_count_);
    glBindVertexArray(0);
}

} // namespace tractus::render
