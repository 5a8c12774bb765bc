#include "engine/methods/leaves/leaf_triangles.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <algorithm>
#include <span>
#include <utility>

namespace tractus::leaf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Corners = std::vector<std::uint32_t>;

bool is_in_triangle(Vec2 const& point, Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return turn(a, b, point) > 0 && turn(b, c, point) > 0 && turn(c, a, point) > 0;
}

// Triangulates the faces of a leaf, one after another.
class Cutter {
public:
    explicit Cutter(LeafTriangles const& leaf)
        : leaf_(leaf)
    {
    }

    // Triangulates a face. Returns false if it overlaps itself or has too many corners; then its
    // triangles form a fan.
    bool cut(Corners const& corners, std::vector<Triangle>& to)
    {
        // Maximum number of corners for ear clipping, which would take too long for larger faces.
        constexpr std::size_t kMaxCorners = 2000;
        if (corners.size() == 4)
            return cut_quad(corners, to);
        if (corners.size() > kMaxCorners) {
            fan(corners, to);
            return false;
        }
        ring_.clear();
        for (auto const corner : corners)
            ring_.push_back({ .vertex = corner, .at = flat(corner) });
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            ring_[i].before = (i + ring_.size() - 1) % ring_.size();
            ring_[i].after = (i + 1) % ring_.size();
        }
        return cut_ears(to);
    }

private:
    Vec2 const& flat(std::uint32_t corner) const { return leaf_.flat[corner]; }

    static void fan(Corners const& corners, std::vector<Triangle>& to)
    {
        for (std::size_t i = 2; i < corners.size(); ++i)
            to.push_back({ corners[0], corners[i - 1], corners[i] });
    }

    double turn_of(Triangle const& t) const { return turn(flat(t[0]), flat(t[1]), flat(t[2])); }

    // Splits a quadrilateral along its shorter diagonal in space, unless one of the two triangles
    // would then be reversed in the flat leaf.
    bool cut_quad(Corners const& q, std::vector<Triangle>& to) const
    {
        std::array<Triangle, 2> const first { { { q[0], q[1], q[2] }, { q[0], q[2], q[3] } } };
        std::array<Triangle, 2> const second { { { q[1], q[2], q[3] }, { q[1], q[3], q[0] } } };
        auto const worst = [&](std::array<Triangle, 2> const& halves) {
            return std::min(turn_of(halves[0]), turn_of(halves[1]));
        };
        auto const& at = leaf_.positions;
        bool const is_first_shorter = (at[q[2]] - at[q[0]]).norm() <= (at[q[3]] - at[q[1]]).norm();
        bool const fits_first = worst(first) > 0;
        bool const fits_second = worst(second) > 0;
        bool const takes_first = fits_first == fits_second ? is_first_shorter : fits_first;
        auto const& halves = takes_first ? first : second;
        to.insert(to.end(), halves.begin(), halves.end());
        return fits_first || fits_second || std::max(worst(first), worst(second)) == 0;
    }

    // A corner of the polygon that remains after ears have been cut off.
    struct Corner {
        std::uint32_t vertex = 0;
        Vec2 at = Vec2::Zero();
        std::size_t before = 0;
        std::size_t after = 0;
        // True for a reflex corner; such corners may lie inside the triangles of other corners.
        bool is_hollow = false;
    };
    // Special values in shapes_: kNoEar for a corner that is not an ear, kCut for one that has
    // already been cut off.
    static constexpr double kNoEar = -1;
    static constexpr double kCut = -2;

    bool cut_ears(std::vector<Triangle>& to)
    {
        hollows_.clear();
        shapes_.assign(ring_.size(), kNoEar);
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            ring_[i].is_hollow = turn_at(i) < 0;
            if (ring_[i].is_hollow)
                hollows_.push_back(ring_[i].at);
        }
        for (std::size_t i = 0; i < ring_.size(); ++i)
            judge(i);
        std::size_t first = 0;
        for (auto left = ring_.size(); left > 3; --left) {
            auto const ear = widest_ear();
            if (!ear) {
                fan(corners_left(first), to);
                return false;
            }
            auto const& corner = ring_[*ear];
            to.push_back(
                { ring_[corner.before].vertex, corner.vertex, ring_[corner.after].vertex });
            shapes_[*ear] = kCut;
            ring_[corner.before].after = corner.after;
            ring_[corner.after].before = corner.before;
            judge_again(corner.before, corner.after);
            if (*ear == first)
                first = corner.after;
        }
        fan(corners_left(first), to);
        return true;
    }

    double turn_at(std::size_t i) const
    {
        auto const& corner = ring_[i];
        return turn(ring_[corner.before].at, corner.at, ring_[corner.after].at);
    }

    Corners corners_left(std::size_t first) const
    {
        Corners left;
        auto i = first;
        do {
            left.push_back(ring_[i].vertex);
            i = ring_[i].after;
        } while (i != first);
        return left;
    }

    // Updates the two corners beside an ear that has been cut off. If one of them is no longer
    // reflex, triangles that contained it may have become ears.
    void judge_again(std::size_t before, std::size_t after)
    {
        bool is_filled = false;
        for (auto const i : { before, after }) {
            if (!ring_[i].is_hollow || turn_at(i) < 0)
                continue;
            ring_[i].is_hollow = false;
            std::erase(hollows_, ring_[i].at);
            is_filled = true;
        }
        if (!is_filled) {
            judge(before);
            judge(after);
            return;
        }
        for (std::size_t i = 0; i < ring_.size(); ++i)
            if (shapes_[i] == kNoEar || i == before || i == after)
                judge(i);
    }

    void judge(std::size_t i)
    {
        auto const& corner = ring_[i];
        auto const& a = ring_[corner.before].at;
        auto const& c = ring_[corner.after].at;
        double const area = turn(a, corner.at, c);
        double const longest = std::max({ (corner.at - a).squaredNorm(),
                                          (c - corner.at).squaredNorm(), (a - c).squaredNorm() });
        bool const is_ear = area >= 0 && std::ranges::none_of(hollows_, [&](Vec2 const& other) {
                                return is_in_triangle(other, a, corner.at, c);
                            });
        shapes_[i] = !is_ear ? kNoEar : longest > 0 ? area / longest : 0;
    }

    // Returns the index of the ear with the best shape (shapes_); no value if there is no ear.
    std::optional<std::size_t> widest_ear() const
    {
        auto const best = std::ranges::max_element(shapes_);
        if (*best < 0)
            return std::nullopt;
        return static_cast<std::size_t>(best - shapes_.begin());
    }

    std::vector<Corner> ring_;
    // Shape of each corner's triangle: twice its area divided by the square of its longest side.
    std::vector<double> shapes_;
    std::vector<Vec2> hollows_;
    LeafTriangles const& leaf_;
};

} // namespace

LeafTriangles triangles_of(Leaf const& leaf)
{
    auto const& map = leaf.map();
    LeafTriangles made;
    std::vector<std::uint32_t> number(map.vertex_count(), ~std::uint32_t { 0 });
    auto const number_of = [&](Dart d) {
        auto& known = number[static_cast<std::size_t>(map.vertex(d))];
        if (known == ~std::uint32_t { 0 }) {
            known = static_cast<std::uint32_t>(made.positions.size());
            made.positions.push_back(map.position_of(d));
            made.flat.push_back(map.flat_of(d));
        }
        return known;
    };
    Cutter cutter(made);
    std::vector<bool> is_seen(map.dart_count());
    // All vertices are numbered before any face is cut, because cutting needs the positions of all
    // corners.
    for (Dart d = 0; d < static_cast<Dart>(map.dart_count()); d += 2)
        number_of(d);
    Corners corners;
    for (Dart d = 0; d < static_cast<Dart>(map.dart_count()); d += 2) {
        if (is_seen[static_cast<std::size_t>(d)])
            continue;
        corners.clear();
        auto x = d;
        do {
            is_seen[static_cast<std::size_t>(x)] = true;
            corners.push_back(number_of(x));
            x = map.a1(LeafMap::a0(x));
        } while (x != d);
        bool const is_limb = map.label(d) >= EdgeLabel::LimbSide;
        bool const is_simple = cutter.cut(corners, is_limb ? made.limb : made.veins);
        made.overlapping_faces += !is_simple && is_limb;
    }
    return made;
}

std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<Vec2 const> corners)
{
    LeafTriangles leaf;
    Corners numbers;
    for (auto const& corner : corners) {
        numbers.push_back(static_cast<std::uint32_t>(leaf.flat.size()));
        leaf.flat.push_back(corner);
        leaf.positions.emplace_back(corner.x(), corner.y(), 0);
    }
    std::vector<Triangle> made;
    if (corners.size() >= 3)
        Cutter(leaf).cut(numbers, made);
    return made;
}

} // namespace tractus::leaf
