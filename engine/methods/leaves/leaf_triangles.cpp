#include "engine/methods/leaves/leaf_triangles.h"

#include <algorithm>
#include <span>
#include <utility>

namespace tractus::leaf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Corners = std::vector<std::uint32_t>;

// Twice the area, positive where the corners run counter-clockwise.
double turn(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_inside(Vec2 const& point, Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return turn(a, b, point) > 0 && turn(b, c, point) > 0 && turn(c, a, point) > 0;
}

// Cuts one face after another into triangles.
class Cutter {
public:
    explicit Cutter(LeafTriangles const& leaf)
        : leaf_(leaf)
    {
    }

    // False if the face overlaps itself.
    bool cut(Corners corners, std::vector<Triangle>& to) const
    {
        constexpr std::size_t kMostCorners = 2000; // Ears are looked for among all corners.
        if (corners.size() == 4)
            return cut_quad(corners, to);
        while (corners.size() > 3) {
            auto const ear = corners.size() > kMostCorners ? std::nullopt : find_ear(corners);
            if (!ear) {
                fan(corners, to);
                return false;
            }
            to.push_back(triangle_at(corners, *ear));
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(*ear));
        }
        fan(corners, to);
        return true;
    }

private:
    Vec2 const& flat(std::uint32_t corner) const { return leaf_.flat[corner]; }

    static Triangle triangle_at(Corners const& corners, std::size_t i)
    {
        auto const count = corners.size();
        return { corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count] };
    }

    static void fan(Corners const& corners, std::vector<Triangle>& to)
    {
        for (std::size_t i = 2; i < corners.size(); ++i)
            to.push_back({ corners[0], corners[i - 1], corners[i] });
    }

    double turn_of(Triangle const& t) const { return turn(flat(t[0]), flat(t[1]), flat(t[2])); }

    // Along the diagonal that is shorter in space, if both halves of the flat face turn as it does.
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

    // The corner whose triangle is widest for its sides, holds no other and turns as the face does.
    std::optional<std::size_t> find_ear(Corners const& corners) const
    {
        std::optional<std::size_t> best;
        double best_shape = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            auto const t = triangle_at(corners, i);
            auto const& [a, b, c] = t;
            double const longest
                = std::max({ (flat(b) - flat(a)).squaredNorm(), (flat(c) - flat(b)).squaredNorm(),
                             (flat(a) - flat(c)).squaredNorm() });
            double const area = turn_of(t);
            double const shape = longest > 0 ? area / longest : 0;
            if (area < 0 || (best && shape <= best_shape) || holds_any(t, corners))
                continue;
            best = i;
            best_shape = shape;
        }
        return best;
    }

    bool holds_any(Triangle const& t, Corners const& corners) const
    {
        return std::ranges::any_of(corners, [&](std::uint32_t corner) {
            return is_inside(flat(corner), flat(t[0]), flat(t[1]), flat(t[2]));
        });
    }

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
    std::vector<std::pair<Corners, bool>> faces; // And whether it is the limb's.
    std::vector<bool> is_seen(map.dart_count());
    for (Dart d = 0; d < static_cast<Dart>(map.dart_count()); d += 2) {
        if (is_seen[static_cast<std::size_t>(d)])
            continue;
        auto& [corners, is_limb]
            = faces.emplace_back(Corners {}, map.label(d) >= EdgeLabel::LimbSide);
        for (auto const start : map.cycle(d)) {
            is_seen[static_cast<std::size_t>(start)] = true;
            corners.push_back(number_of(start));
        }
    }
    Cutter const cutter(made);
    for (auto& [corners, is_limb] : faces)
        made.overlapping_faces
            += !cutter.cut(std::move(corners), is_limb ? made.limb : made.veins) && is_limb;
    return made;
}

} // namespace tractus::leaf
