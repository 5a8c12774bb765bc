#include "app/station/ink_line.h"

#include <algorithm>
#include <utility>

namespace tractus {

namespace {

constexpr double kInkWidth_mm = 3.5;

// Place and width, which are to change as little.
Eigen::Vector4f dot(InkLine::Point const& point)
{
    return { point.position_mm.x(), point.position_mm.y(), point.position_mm.z(), point.width_mm };
}

struct Farthest {
    std::size_t index = 0;
    float distance_mm = 0;
};

// The point between two others that is farthest from the straight line between them.
Farthest farthest_between(std::vector<InkLine::Point> const& points, std::size_t first,
                          std::size_t last)
{
    auto const start = dot(points[first]);
    Eigen::Vector4f const way = dot(points[last]) - start;
    float const length2 = std::max(way.squaredNorm(), 1e-12f);
    Farthest farthest;
    for (auto i = first + 1; i < last; ++i) {
        Eigen::Vector4f const to_point = dot(points[i]) - start;
        float const share = std::clamp(to_point.dot(way) / length2, 0.0f, 1.0f);
        float const distance_mm = (to_point - share * way).norm();
        if (distance_mm > farthest.distance_mm)
            farthest = { i, distance_mm };
    }
    return farthest;
}

} // namespace

InkLine ink_line(std::vector<TipSample> const& tips, Tool const& tool)
{
    InkLine line;
    bool const erases = tool.kind == Tool::Kind::Erase;
    if (erases)
        line.kind = InkLine::Kind::Eraser;
    else if (tool.kind == Tool::Kind::Indicate)
        line.kind = InkLine::Kind::Indicator;
    line.points.reserve(tips.size());
    for (auto const& tip : tips) {
        double const share = 0.35 + 0.65 * tip.pressure;
        line.points.push_back(
            { tip.position_mm.cast<float>(),
              static_cast<float>(erases ? 2 * kEraserRadius_mm : kInkWidth_mm * share) });
    }
    return line;
}

InkLine indicator_line(MotionIndicator const& indicator)
{
    InkLine line;
    line.kind = InkLine::Kind::Indicator;
    for (auto const& place_mm : { indicator.start_mm, indicator.end_mm })
        line.points.push_back({ place_mm.cast<float>(), static_cast<float>(kInkWidth_mm) });
    return line;
}

// Douglas and Peucker's way: a point stays if the line between those that stay leaves it.
InkLine thinned(InkLine const& line)
{
    auto const& points = line.points;
    if (points.size() < 3)
        return line;
    std::vector<bool> stays(points.size());
    stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> parts { { 0, points.size() - 1 } };
    while (!parts.empty()) {
        auto const [first, last] = parts.back();
        parts.pop_back();
        auto const [index, distance_mm] = farthest_between(points, first, last);
        if (distance_mm <= static_cast<float>(kThinned_mm))
            continue;
        stays[index] = true;
        parts.push_back({ first, index });
        parts.push_back({ index, last });
    }
    InkLine thin { {}, line.kind };
    thin.points.reserve(static_cast<std::size_t>(std::count(stays.begin(), stays.end(), true)));
    for (std::size_t i = 0; i < points.size(); ++i)
        if (stays[i])
            thin.points.push_back(points[i]);
    return thin;
}

} // namespace tractus
