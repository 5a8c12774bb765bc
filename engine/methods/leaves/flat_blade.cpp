#include "engine/methods/leaves/flat_blade.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tractus::leaf {

namespace {

using SpaceLine = std::vector<Vec3>;

// A polynomial, fitted by least squares over the range 0 to 1. It need not pass through the
// midrib's ends on the outline, because these are less certain than the midrib's course as a whole.
template<int kTerms> class Bow {
public:
    using Terms = Eigen::Matrix<double, kTerms, 1>;

    Bow() = default;
    // Fits the polynomial to points (x, y), ignoring those whose x is outside 0 to 1.
    explicit Bow(std::vector<Vec2> const& places)
    {
        Eigen::Matrix<double, kTerms, kTerms> moments
            = 1e-9 * Eigen::Matrix<double, kTerms, kTerms>::Identity();
        Terms sums = Terms::Zero();
        for (auto const& place : places) {
            if (place.x() < 0 || place.x() > 1)
                continue;
            Terms const row = powers(place.x());
            moments += row * row.transpose();
            sums += place.y() * row;
        }
        terms_ = moments.inverse() * sums;
    }

    double at(double t) const { return terms_.dot(powers(t)); }
    double slope(double t) const
    {
        double sum = 0;
        double power = 1;
        for (int i = 1; i < kTerms; ++i) {
            sum += i * terms_[i] * power;
            power *= t;
        }
        return sum;
    }

private:
    static Terms powers(double t)
    {
        Terms made;
        made[0] = 1;
        for (int i = 1; i < kTerms; ++i)
            made[i] = t * made[i - 1];
        return made;
    }

    Terms terms_ = Terms::Zero();
};

// Two perpendicular directions in the plane of the leaf, as seen against its normal.
struct Seen {
    Vec3 right;
    Vec3 up;

    explicit Seen(Vec3 const& normal)
    {
        up = normal.cross(std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
        right = up.cross(normal);
    }
    Vec2 flat(Vec3 const& at) const { return { at.dot(right), at.dot(up) }; }
    FlatLine flat(SpaceLine const& line) const
    {
        FlatLine made;
        for (auto const& at : line)
            made.push_back(flat(at));
        return made;
    }
};

// First intersection of a ray with a closed line, as a fractional index of the line's points. No
// value if it is farther away than `most`.
std::optional<double> first_on_ring(FlatLine const& ring, Vec2 const& from, Vec2 const& way,
                                    double most)
{
    std::optional<double> found;
    double best = most;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 const a = ring[i] - from;
        Vec2 const side = ring[(i + 1) % ring.size()] - ring[i];
        double const across = cross(way, side);
        if (across == 0)
            continue;
        double const far = cross(a, side) / across;
        double const along = cross(a, way) / across;
        if (along >= 0 && along <= 1 && far >= 0 && far < best) {
            best = far;
            found = double(i) + along;
        }
    }
    return found;
}

// Returns the place where a line that begins inside a closed line leaves it, or would leave it if
// extended, as a fractional index of the closed line's points.
double exit_of(FlatLine const& ring, FlatLine const& outwards)
{
    // Maximum extension of the line, as a share of its length: a midrib may be drawn too short.
    constexpr double kMax = 0.15;
    double const length = length_of(outwards);
    auto const last_inside = std::find_if(outwards.rbegin(), outwards.rend(),
                                          [&](Vec2 const& at) { return is_inside(ring, at); });
    Vec2 const end = last_inside == outwards.rend() ? outwards.back() : *last_inside;
    auto const i = static_cast<std::size_t>(outwards.rend() - last_inside);
    auto const back = std::min<std::size_t>(i, std::max<std::size_t>(outwards.size() / 8, 4));
    Vec2 const from = outwards[i > back ? i - back : 0];
    if ((end - from).norm() > 0) {
        Vec2 const way = (end - from).normalized();
        if (auto const found = first_on_ring(ring, end, way, kMax * length))
            return *found;
    }
    return nearest_on(ring, end).along;
}

// Turn of a closed line at a point, in degrees, positive to the left, measured over `reach` points
// on both sides.
double turn_at(FlatLine const& ring, std::size_t i, std::size_t reach)
{
    auto const n = ring.size();
    Vec2 const before = ring[i] - ring[(i + n - reach) % n];
    Vec2 const behind = ring[(i + reach) % n] - ring[i];
    return degrees(std::atan2(cross(before, behind), before.dot(behind)));
}

// Returns the index of a pointed tip of the outline near the midrib's exit, where the midrib was
// probably meant to end; the index `exit` if there is no such tip.
double tip_beside(FlatLine const& ring, double exit, double extent)
{
    constexpr double kMinTurn = 40;
    double const step = length_of(ring) / double(ring.size());
    auto const reach = std::max<std::size_t>(static_cast<std::size_t>(0.03 * extent / step), 5);
    auto const aside = static_cast<std::ptrdiff_t>(0.035 * extent / step);
    auto const n = static_cast<std::ptrdiff_t>(ring.size());
    double const sense = area_of(ring) > 0 ? 1 : -1;
    double best = kMinTurn;
    double found = exit;
    for (std::ptrdiff_t k = -aside; k <= aside; ++k) {
        auto const i = static_cast<std::size_t>(
            ((static_cast<std::ptrdiff_t>(std::round(exit)) + k) % n + n) % n);
        double const turn = sense * turn_at(ring, i, reach);
        if (turn > best) {
            best = turn;
            found = double(i);
        }
    }
    return found;
}

Vec3 space_place_at(SpaceLine const& ring, double along)
{
    auto const i = static_cast<std::size_t>(along) % ring.size();
    double const share = along - std::floor(along);
    return ring[i] + share * (ring[(i + 1) % ring.size()] - ring[i]);
}

// The part of a closed line from one place to another, in the line's direction.
SpaceLine part_of_ring(SpaceLine const& ring, double from, double to)
{
    auto const n = double(ring.size());
    double const span = to > from ? to - from : to - from + n;
    SpaceLine part { space_place_at(ring, from) };
    for (double i = std::floor(from) + 1; i < from + span; ++i)
        part.push_back(ring[static_cast<std::size_t>(i) % ring.size()]);
    part.push_back(space_place_at(ring, to));
    return part;
}

class BladeFlattener {
public:
    explicit BladeFlattener(RecognisedLeaf const& leaf)
        : leaf_(leaf)
    {
    }

    Result<FlatBlade> lay_flat()
    {
        TRY(find_halves());
        find_frame();
        find_shape();
        FlatBlade blade { .size_mm = size_, .place = { base_, tip_, normal_ } };
        for (auto const& at : right_)
            blade.right.push_back(flat(at));
        for (auto const& at : left_)
            blade.left.push_back(flat(at));
        // A single half outline on the left is mirrored to the right, together with its veins.
        bool const mirrors = left_.empty() && area_of(blade.right) < 0;
        mirror_ = mirrors ? -1 : 1;
        if (mirrors)
            for (auto& at : blade.right)
                at.x() = -at.x();
        for (auto const& vein : leaf_.mains)
            blade.mains.push_back(flat_vein(vein.line));
        for (auto const& vein : leaf_.sides)
            blade.sides.push_back(flat_vein(vein.line));
        measure_shape(blade);
        return blade;
    }

private:
    SpaceLine const& rib() const { return leaf_.mains[0].line; }

    Result<void> find_halves()
    {
        auto ring = leaf_.outline;
        Seen const seen(leaf_.normal);
        if (leaf_.edge == RecognisedLeaf::Edge::OneHalf) {
            right_ = ring;
        } else {
            auto flat_ring = seen.flat(ring);
            if (area_of(flat_ring) < 0) {
                std::ranges::reverse(ring);
                std::ranges::reverse(flat_ring);
            }
            auto const flat_rib = seen.flat(rib());
            double const extent = extent_of(flat_ring);
            double const tip = tip_beside(flat_ring, exit_of(flat_ring, flat_rib), extent);
            double const base = exit_of(flat_ring, FlatLine(flat_rib.rbegin(), flat_rib.rend()));
            right_ = part_of_ring(ring, base, tip);
            left_ = part_of_ring(ring, tip, base);
            std::ranges::reverse(left_);
        }
        base_ = right_.front();
        tip_ = right_.back();
        length_ = (tip_ - base_).norm();
        // Minimum length of the blade, as a share of the midrib's drawn length.
        constexpr double kMin = 0.2;
        if (right_.size() < 8 || length_ < kMin * (rib().back() - rib().front()).norm())
            return fail(Fault::User,
                        "the outline does not lie round the midrib: draw the midrib from the "
                        "stalk to the tip, and the outline round it");
        return {};
    }

    void find_frame()
    {
        up_ = (tip_ - base_) / length_;
        normal_ = (leaf_.normal - leaf_.normal.dot(up_) * up_).normalized();
        right_way_ = up_.cross(normal_);
    }

    // Coordinates in the blade's frame: to the right, along the line from base to tip, and along
    // the normal.
    Vec3 framed(Vec3 const& at) const
    {
        Vec3 const from_base = at - base_;
        return { from_base.dot(right_way_), from_base.dot(up_), from_base.dot(normal_) };
    }

    // Fits two curves of the midrib, its sideways offset and its height, and the rise of the blade
    // beside it.
    void find_shape()
    {
        std::vector<Vec2> aside;
        std::vector<Vec2> above;
        for (auto const& point : rib()) {
            Vec3 const at = framed(point);
            aside.emplace_back(at.y() / length_, at.x());
            above.emplace_back(at.y() / length_, at.z());
        }
        aside_ = Bow<3>(aside);
        above_ = Bow<4>(above);
        double sum = 0;
        double squares = 1e-9;
        auto const look_at = [&](SpaceLine const& line) {
            for (auto const& point : line) {
                Vec3 const at = framed(point);
                double const t = std::clamp(at.y() / length_, 0.0, 1.0);
                double const far = std::abs(at.x() - aside_.at(t));
                sum += far * (at.z() - above_.at(t));
                squares += far * far;
            }
        };
        look_at(right_);
        look_at(left_);
        rise_ = std::clamp(sum / squares, -2.0, 2.0);
        for (int i = 0; i <= kPieces; ++i) {
            double const t = double(i) / kPieces;
            curve_.emplace_back(aside_.at(t), t * length_, above_.at(t));
            along_.push_back(
                i == 0 ? 0 : along_.back() + (curve_.back() - curve_[curve_.size() - 2]).norm());
        }
        size_ = along_.back();
    }

    // Converts a point to coordinates across the midrib's curve and along it. The curve is extended
    // straight beyond its ends.
    Vec2 flat(Vec3 const& point) const
    {
        Vec2 const at = framed(point).head<2>();
        double best = -1;
        Vec2 found = Vec2::Zero();
        for (std::size_t i = 0; i + 1 < curve_.size(); ++i) {
            Vec2 const from = curve_[i].head<2>();
            Vec2 const step = curve_[i + 1].head<2>() - from;
            double share = (at - from).dot(step) / step.squaredNorm();
            share = std::clamp(share, i == 0 ? -1e9 : 0.0, i + 2 == curve_.size() ? 1e9 : 1.0);
            Vec2 const away = at - from - share * step;
            if (best >= 0 && away.norm() >= best)
                continue;
            best = away.norm();
            double const side = cross(step, away) > 0 ? -1 : 1;
            found = { side * best * std::hypot(1, rise_),
                      along_[i] + share * (along_[i + 1] - along_[i]) };
        }
        return found / size_;
    }

    FlatLine flat_vein(SpaceLine const& line) const
    {
        FlatLine made;
        for (auto const& point : line) {
            made.push_back(flat(point));
            made.back().x() *= mirror_;
        }
        return made;
    }

    void measure_shape(FlatBlade& blade) const
    {
        auto const slope_deg
            = [&](auto const& bow, double t) { return degrees(std::atan2(bow.slope(t), length_)); };
        blade.bend_low_deg = slope_deg(above_, 0) - slope_deg(above_, 0.5);
        blade.bend_high_deg = slope_deg(above_, 0.5) - slope_deg(above_, 1);
        blade.sweep_deg = slope_deg(aside_, 1) - slope_deg(aside_, 0);
        blade.rise_deg = degrees(std::atan(rise_));
        double outside = -blade.mains[0].front().y();
        for (auto const& at : leaf_.stalk)
            outside = std::max(outside, (at - base_).norm() / size_);
        blade.stalk = std::max(0.0, outside);
    }

    static constexpr int kPieces = 96;

    RecognisedLeaf const& leaf_;
    SpaceLine right_;
    SpaceLine left_;
    Vec3 base_ = Vec3::Zero();
    Vec3 tip_ = Vec3::Zero();
    double length_ = 0;
    Vec3 up_ = Vec3::UnitY();
    Vec3 normal_ = Vec3::UnitZ();
    Vec3 right_way_ = Vec3::UnitX();
    Bow<3> aside_;
    Bow<4> above_;
    double rise_ = 0;
    SpaceLine curve_;           // The midrib's curve in the blade's frame.
    std::vector<double> along_; // Arc length at each point of `curve_`.
    double size_ = 0;
    double mirror_ = 1;
};

} // namespace

Result<FlatBlade> lay_flat(RecognisedLeaf const& leaf)
{
    return BladeFlattener(leaf).lay_flat();
}

} // namespace tractus::leaf
