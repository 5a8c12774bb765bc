#include "app/view/ink_line.h"

#include "engine/stroke/ink_width.h"

#include <algorithm>
#include <cstddef>

namespace tractus::view {

namespace {

// Returns a point's position and width as one vector, so that one tolerance limits the change of
// both.
Eigen::Vector4f dot(InkLine::Point const& point)
{
    return { point.position_mm.x(), point.position_mm.y(), point.position_mm.z(), point.width_mm };
}

// True if the straight line between two points passes all points between them within kThinned_mm.
bool is_straight(std::vector<InkLine::Point> const& points, std::size_t first, std::size_t last)
{
    auto const start = dot(points[first]);
    Eigen::Vector4f const way = dot(points[last]) - start;
    float const length2 = std::max(way.squaredNorm(), 1e-12f);
    for (auto i = first + 1; i < last; ++i) {
        Eigen::Vector4f const to_point = dot(points[i]) - start;
        float const share = std::clamp(to_point.dot(way) / length2, 0.0f, 1.0f);
        if ((to_point - share * way).norm() > static_cast<float>(kThinned_mm))
            return false;
    }
    return true;
}

// Returns the index of the farthest point that one straight line from `first` can reach. `first`
// must not be the last point. The search uses strides that double and then halve: testing every
// point of a long stroke would take quadratic time.
std::size_t straight_until(std::vector<InkLine::Point> const& points, std::size_t first)
{
    auto last = first + 1;
    auto const can_go = [&](std::size_t stride) {
        return last + stride < points.size() && is_straight(points, first, last + stride);
    };
    std::size_t stride = 1;
    for (; can_go(stride); stride *= 2)
        last += stride;
    for (; stride > 0; stride /= 2)
        if (can_go(stride))
            last += stride;
    return last;
}

} // namespace

InkLine ink_line(std::vector<TipSample> const& tips, tools::Tool const& tool, Nib nib)
{
    InkLine line;
    auto const& style = tool.kind().ink;
    line.look = style.look;
    line.points.reserve(tips.size());
    for (std::size_t i = 0; i < tips.size(); ++i) {
        double const share = ink_width_share(tips[i].pressure) * broadening(nib, tips, i);
        line.points.push_back(
            { tips[i].position_mm.cast<float>(),
              static_cast<float>(style.width_mm > 0 ? style.width_mm : kInkWidth_mm * share) });
    }
    return line;
}

InkLine thinned(InkLine const& line)
{
    if (line.points.empty())
        return line;
    InkLine thin { { line.points.front() }, line.look };
    for (std::size_t i = 0; i + 1 < line.points.size();) {
        i = straight_until(line.points, i);
        thin.points.push_back(line.points[i]);
    }
    thin.points.shrink_to_fit(); // The line is kept for hours, so unused memory is freed.
    return thin;
}

} // namespace tractus::view
