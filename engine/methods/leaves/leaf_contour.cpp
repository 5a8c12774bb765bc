#include "engine/methods/leaves/leaf_contour.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::leaf {

double contour_area(Contour const& contour)
{
    double sum = 0;
    for (std::size_t i = 0; i < contour.size(); ++i)
        sum += cross(contour[i], contour[(i + 1) % contour.size()]);
    return sum / 2;
}

namespace {

// Traces contours in a grid of squares whose corners are the pixel centres. The grid has a border
// of one empty pixel, so that all contours are closed.
class Tracer {
public:
    Tracer(std::span<float const> alpha, int side, double level)
        : alpha_(alpha)
        , side_(side)
        , level_(level)
    {
    }

    std::vector<Contour> trace(double min_area)
    {
        for (int y = -1; y < side_; ++y)
            for (int x = -1; x < side_; ++x)
                add_square(x, y);
        std::ranges::sort(steps_);
        std::vector<bool> is_done(steps_.size());
        std::vector<Contour> contours;
        for (std::size_t first = 0; first < steps_.size(); ++first) {
            if (is_done[first])
                continue;
            Contour contour;
            for (auto i = first; !is_done[i]; i = step_from(steps_[i].second)) {
                is_done[i] = true;
                contour.push_back(place(steps_[i].first));
            }
            if (std::abs(contour_area(contour)) >= min_area)
                contours.push_back(std::move(contour));
        }
        return contours;
    }

private:
    // Number of an edge between two neighbouring pixel centres: 2 * (the first one's index in the
    // bordered grid), plus 1 if the edge points up.
    using Edge = std::int32_t;
    enum Side : std::uint8_t { Bottom, Right, Top, Left };

    // Alpha at a pixel centre; y upwards.
    double value(int x, int y) const
    {
        if (x < 0 || y < 0 || x >= side_ || y >= side_)
            return 0;
        return double(
            alpha_[static_cast<std::size_t>(side_ - 1 - y) * static_cast<std::size_t>(side_)
                   + static_cast<std::size_t>(x)]);
    }

    Edge edge(int x, int y, Side side) const
    {
        int const columns = side_ + 2;
        int const right = side == Right ? 1 : 0;
        int const up = side == Top ? 1 : 0;
        bool const is_upright = side == Left || side == Right;
        return 2 * ((y + 1 + up) * columns + x + 1 + right) + (is_upright ? 1 : 0);
    }

    void add_square(int x, int y)
    {
        std::array const values { value(x, y), value(x + 1, y), value(x + 1, y + 1),
                                  value(x, y + 1) };
        unsigned inside = 0;
        for (unsigned i = 0; i < 4; ++i)
            inside |= values[i] >= level_ ? 1u << i : 0u;
        if (inside == 0 || inside == 15)
            return;
        bool const is_saddle = inside == 5 || inside == 10;
        double const mean = (values[0] + values[1] + values[2] + values[3]) / 4;
        if (is_saddle && mean >= level_) {
            // The two inner corners are joined: the steps go round the outer ones.
            for (unsigned i = 0; i < 4; ++i)
                if ((inside >> i & 1u) == 0)
                    add_step(x, y, side_before(i), side_after(i));
            return;
        }
        // One step for each run of inner corners, around it: from the side behind the run's last
        // corner to the side before its first one.
        for (unsigned first = 0; first < 4; ++first) {
            if ((inside >> first & 1u) == 0 || (inside >> (first + 3) % 4 & 1u) != 0)
                continue;
            unsigned last = first;
            while (inside >> (last + 1) % 4 & 1u)
                ++last;
            add_step(x, y, side_after(last % 4), side_before(first));
        }
    }

    // Sides of a square before and after a corner, counter-clockwise from the lower left corner.
    static Side side_after(unsigned corner) { return static_cast<Side>(corner); }
    static Side side_before(unsigned corner) { return static_cast<Side>((corner + 3) % 4); }

    void add_step(int x, int y, Side from, Side to)
    {
        steps_.emplace_back(edge(x, y, from), edge(x, y, to));
    }

    std::size_t step_from(Edge edge) const
    {
        auto const found
            = std::ranges::lower_bound(steps_, edge, {}, &std::pair<Edge, Edge>::first);
        return static_cast<std::size_t>(found - steps_.begin());
    }

    Vec2 place(Edge edge) const
    {
        int const columns = side_ + 2;
        int const x = edge / 2 % columns - 1;
        int const y = edge / 2 / columns - 1;
        bool const is_upright = edge % 2 != 0;
        double const from = value(x, y);
        double const to = is_upright ? value(x, y + 1) : value(x + 1, y);
        double const share = from != to ? (level_ - from) / (to - from) : 0.5;
        return { x + 0.5 + (is_upright ? 0 : share), y + 0.5 + (is_upright ? share : 0) };
    }

    std::span<float const> alpha_;
    int side_;
    double level_;
    std::vector<std::pair<Edge, Edge>> steps_; // Edges where a step starts and where it ends.
};

double distance_to_segment(Vec2 const& point, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const length2 = along.squaredNorm();
    double const share = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0;
    return (point - a - share * along).norm();
}

} // namespace

std::vector<Contour> trace_contours(std::span<float const> alpha, int side, double level,
                                    double min_area)
{
    return Tracer(alpha, side, level).trace(min_area);
}

Contour thinned(Contour const& contour, double tolerance)
{
    auto const count = contour.size();
    if (count < 4)
        return contour;
    auto const farther = [&](Vec2 const& a, Vec2 const& b) {
        return (a - contour[0]).squaredNorm() < (b - contour[0]).squaredNorm();
    };
    auto const far
        = static_cast<std::size_t>(std::ranges::max_element(contour, farther) - contour.begin());
    std::vector<bool> stays(count);
    stays[0] = stays[far] = true;
    std::vector<std::pair<std::size_t, std::size_t>> pending { { 0, far }, { far, count } };
    while (!pending.empty()) {
        auto const [from, to] = pending.back();
        pending.pop_back();
        double most = tolerance;
        std::size_t at = from;
        for (auto i = from + 1; i < to; ++i) {
            double const off = distance_to_segment(contour[i], contour[from], contour[to % count]);
            if (off > most) {
                most = off;
                at = i;
            }
        }
        if (at == from)
            continue;
        stays[at] = true;
        pending.emplace_back(from, at);
        pending.emplace_back(at, to);
    }
    Contour made;
    for (std::size_t i = 0; i < count; ++i)
        if (stays[i])
            made.push_back(contour[i]);
    return made;
}

namespace {

// Performs the steps of grow_simpler() on a ring of points.
class Simplifier {
public:
    Simplifier(Contour& contour, double side)
        : contour_(contour)
        , side_(side)
    {
        for (std::size_t i = 0; i < contour.size(); ++i)
            ring_.push_back({ .at = contour[i],
                              .before = (i + contour.size() - 1) % contour.size(),
                              .after = (i + 1) % contour.size() });
        added_.assign(ring_.size(), kNever);
        for (std::size_t i = 0; i < ring_.size(); ++i)
            judge(i);
    }

    void simplify(double area, double step_area)
    {
        std::size_t left = ring_.size();
        while (left > 4) {
            auto const best = std::ranges::min_element(added_);
            double const added = *best;
            if (!(added <= std::min(area, step_area)))
                break;
            auto const i = static_cast<std::size_t>(best - added_.begin());
            if (crosses(i)) {
                added_[i] = kNever;
                continue;
            }
            area -= added;
            take_step(i);
            --left;
        }
        contour_.clear();
        auto const there
            = std::ranges::find_if(ring_, [](Point const& point) { return !point.is_gone; });
        auto const first = static_cast<std::size_t>(there - ring_.begin());
        auto i = first;
        do {
            contour_.push_back(ring_[i].at);
            i = ring_[i].after;
        } while (i != first);
    }

private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    struct Point {
        Vec2 at = Vec2::Zero();
        std::size_t before = 0;
        std::size_t after = 0;
        bool is_gone = false;
        // The step at this point: an inner corner is left out, or the side after an outer corner is
        // replaced by the point `peak`.
        bool is_side = false;
        Vec2 peak = Vec2::Zero();
    };

    Vec2 const& at(std::size_t i) const { return ring_[i].at; }

    void judge(std::size_t i)
    {
        auto& point = ring_[i];
        Vec2 const& before = at(point.before);
        Vec2 const& after = at(point.after);
        double const turned = turn(before, point.at, after);
        added_[i] = kNever;
        point.is_side = turned > 0;
        if (!point.is_side) {
            added_[i] = -turned / 2;
            return;
        }
        Vec2 const& beyond = at(ring_[point.after].after);
        Vec2 const in = point.at - before;
        Vec2 const out = after - beyond;
        double const across = cross(in, out);
        if (turn(point.at, after, beyond) <= 0 || across >= 0)
            return;
        double const far = cross(after - point.at, out) / across;
        point.peak = point.at + far * in;
        bool const is_inside = point.peak.minCoeff() >= 0 && point.peak.maxCoeff() <= side_;
        if (far > 0 && is_inside)
            added_[i] = std::abs(turn(point.at, point.peak, after)) / 2;
    }

    // True if a new side of the step at i would cross another side, or touch one of its ends.
    bool crosses(std::size_t i) const
    {
        auto const& point = ring_[i];
        auto const before = point.before;
        auto const after = point.is_side ? ring_[point.after].after : point.after;
        std::array<std::pair<Vec2, Vec2>, 2> const made {
            { { at(before), point.is_side ? point.peak : at(after) },
              { point.is_side ? point.peak : at(before), at(after) } }
        };
        Eigen::AlignedBox2d box(at(before));
        box.extend(at(after));
        if (point.is_side)
            box.extend(point.peak);
        for (auto j = after; j != before; j = ring_[j].after) {
            Vec2 const& c = at(j);
            Vec2 const& d = at(ring_[j].after);
            bool const is_far = std::max(c.x(), d.x()) < box.min().x()
                || std::min(c.x(), d.x()) > box.max().x() || std::max(c.y(), d.y()) < box.min().y()
                || std::min(c.y(), d.y()) > box.max().y();
            if (is_far)
                continue;
            for (auto const& [a, b] : made) {
                bool const is_near_a = j == before || ring_[j].after == before;
                bool const is_near_b = j == after;
                double const c_side = turn(a, b, c);
                double const d_side = turn(a, b, d);
                double const a_side = turn(c, d, a);
                double const b_side = turn(c, d, b);
                bool const is_crossed = c_side * d_side < 0 && a_side * b_side < 0;
                bool const is_touched
                    = !is_near_a && !is_near_b && c_side * d_side <= 0 && a_side * b_side <= 0;
                if (is_crossed || is_touched)
                    return true;
            }
        }
        return false;
    }

    void take_step(std::size_t i)
    {
        auto& point = ring_[i];
        if (point.is_side) {
            auto& gone = ring_[point.after];
            gone.is_gone = true;
            added_[point.after] = kNever;
            point.at = point.peak;
            point.after = gone.after;
            ring_[point.after].before = i;
        } else {
            point.is_gone = true;
            added_[i] = kNever;
            ring_[point.before].after = point.after;
            ring_[point.after].before = point.before;
        }
        // The steps of points up to two before and after depend on what has changed.
        auto j = ring_[i].before;
        j = ring_[j].before;
        for (int k = 0; k < 5; ++k) {
            if (!ring_[j].is_gone)
                judge(j);
            j = ring_[j].after;
        }
    }

    Contour& contour_;
    double side_;
    std::vector<Point> ring_;
    // Area that the step at each point adds; infinite if there is none.
    std::vector<double> added_;
};

} // namespace

void grow_simpler(Contour& contour, double area, double step_area, double side)
{
    if (contour.size() > 4)
        Simplifier(contour, side).simplify(area, step_area);
}

} // namespace tractus::leaf
