#include "engine/methods/leaves/flat_line.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::leaf {

double length_of(std::span<Vec2 const> line)
{
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

double area_of(std::span<Vec2 const> ring)
{
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5 * twice;
}

bool is_inside(std::span<Vec2 const> ring, Vec2 const& place)
{
    bool inside = false;
    for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
        auto const& a = ring[before];
        auto const& b = ring[i];
        if ((a.y() > place.y()) != (b.y() > place.y())
            && place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

double area_share_left_of(std::span<Vec2 const> ring, Vec2 const& from, Vec2 const& to)
{
    Vec2 const way = to - from;
    FlatLine left;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        auto const& a = ring[i];
        auto const& b = ring[(i + 1) % ring.size()];
        double const side_a = cross(way, a - from);
        double const side_b = cross(way, b - from);
        if (side_a >= 0)
            left.push_back(a);
        if ((side_a >= 0) != (side_b >= 0))
            left.push_back(a + side_a / (side_a - side_b) * (b - a));
    }
    double const whole = std::abs(area_of(ring));
    return whole > 0 ? std::abs(area_of(left)) / whole : 0;
}

double extent_of(std::span<Vec2 const> line)
{
    Eigen::AlignedBox2d box;
    for (auto const& point : line)
        box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

NearestOnLine nearest_on(std::span<Vec2 const> line, Vec2 const& place)
{
    NearestOnLine best { (line.front() - place).norm(), 0 };
    for (std::size_t i = 1; i < line.size(); ++i) {
        Vec2 const step = line[i] - line[i - 1];
        double const length2 = step.squaredNorm();
        double const share
            = length2 > 0 ? std::clamp((place - line[i - 1]).dot(step) / length2, 0.0, 1.0) : 0;
        double const distance = (line[i - 1] + share * step - place).norm();
        if (distance < best.distance)
            best = { distance, double(i - 1) + share };
    }
    return best;
}

Vec2 place_at(std::span<Vec2 const> line, double along)
{
    double const held = std::clamp(along, 0.0, double(line.size() - 1));
    auto const i = std::min(static_cast<std::size_t>(held), line.size() - 1);
    if (i + 1 == line.size())
        return line.back();
    return line[i] + (held - double(i)) * (line[i + 1] - line[i]);
}

FlatLine evenly(std::span<Vec2 const> line, std::size_t count)
{
    double const length = length_of(line);
    FlatLine made { line.front() };
    double done = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        double const step = (line[i] - line[i - 1]).norm();
        while (made.size() + 1 < count) {
            double const wanted = length * double(made.size()) / double(count - 1);
            if (wanted > done + step)
                break;
            made.push_back(line[i - 1]
                           + (step > 0 ? (wanted - done) / step : 0) * (line[i] - line[i - 1]));
        }
        done += step;
    }
    while (made.size() < count)
        made.push_back(line.back());
    return made;
}

} // namespace tractus::leaf
