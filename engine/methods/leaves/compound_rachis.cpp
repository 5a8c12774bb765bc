#include "engine/methods/leaves/compound_rachis.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tractus::leaf {

namespace {

constexpr double kMinPiece = 0.002;
constexpr double kMinLeafletStalk = 0.01;

Vec2 left_of(Vec2 const& way)
{
    return { -way.y(), way.x() };
}

// Angle from one direction to another, positive to the right (clockwise).
double right_turn_deg(Vec2 const& from, Vec2 const& to)
{
    return -degrees(std::atan2(cross(from, to), from.dot(to)));
}

// The sheet on which a drawn compound leaf is laid: from the petiole's beginning, along its first
// part, in units of the longest leaflet's length.
class Sheet {
public:
    Sheet(RecognisedLeaf const& drawn, double size_mm)
        : origin_(drawn.rachis.front())
        , size_mm_(size_mm)
    {
        normal_ = drawn.normal.normalized();
        Vec3 const rough = std::abs(normal_.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
        up_ = normal_.cross(rough).normalized();
        right_ = up_.cross(normal_);
    }

    // Turns the sheet so that `way` points up.
    void point_up(Vec2 const& way)
    {
        Vec3 const up = (way.x() * right_ + way.y() * up_).normalized();
        up_ = up;
        right_ = up_.cross(normal_);
    }

    Vec2 flat(Vec3 const& at) const
    {
        return Vec2((at - origin_).dot(right_), (at - origin_).dot(up_)) / size_mm_;
    }
    FlatLine flat(std::vector<Vec3> const& line) const
    {
        FlatLine made;
        for (auto const& at : line)
            made.push_back(flat(at));
        return made;
    }
    Vec3 in_space(Vec2 const& at) const
    {
        return origin_ + size_mm_ * (at.x() * right_ + at.y() * up_);
    }
    Vec3 const& normal() const { return normal_; }

private:
    Vec3 origin_;
    double size_mm_;
    Vec3 normal_;
    Vec3 up_;
    Vec3 right_;
};

// A leaflet on the sheet.
struct DrawnBlade {
    Vec2 base = Vec2::Zero();
    Vec2 way = Vec2::UnitY(); // Unit vector from base to tip.
    double size = 1;
    double side = 1;          // 1: on the left of the rachis; -1: on its right.
    double along = 0;         // Position of its foot on the rachis, as a fractional index.
    Vec2 foot = Vec2::Zero(); // Where it stands, on the rachis' middle line.
    bool is_end = false;
};

class RachisMeasurer {
public:
    RachisMeasurer(RecognisedLeaf const& drawn, std::span<BladePlace const> places,
                   DrawnLeaf const& leaf)
        : drawn_(drawn)
        , width_(kRachisWidths * leaf.width)
        , sheet_(drawn, leaf.size_mm)
        , rachis_(evenly(sheet_.flat(drawn.rachis), kSamples))
    {
        for (auto const& place : places) {
            Vec2 const base = sheet_.flat(place.base_mm);
            Vec2 const way = sheet_.flat(place.tip_mm) - base;
            blades_.push_back({ .base = base, .way = way.normalized(), .size = way.norm() });
        }
        find_end();
        for (auto& blade : blades_)
            if (!blade.is_end)
                stand(blade);
        std::ranges::stable_sort(blades_, [](DrawnBlade const& a, DrawnBlade const& b) {
            return a.is_end != b.is_end ? b.is_end : a.along < b.along;
        });
    }

    MeasuredRachis measure()
    {
        MeasuredRachis made;
        for (auto const& blade : blades_)
            if (!blade.is_end)
                made.leaflets.push_back(next_leaflet(blade));
        made.end = end_piece();
        sheet_.point_up(first_way_);
        for (auto const& leaflet : drawn_.leaflets)
            made.outlines.push_back(sheet_.flat(leaflet.outline));
        Vec2 const begin(0, made.leaflets.front().piece);
        made.place
            = { sheet_.in_space(begin), sheet_.in_space(begin + Vec2::UnitY()), sheet_.normal() };
        return made;
    }

private:
    static constexpr std::size_t kSamples = 400;

    Vec2 tangent(double along) const
    {
        constexpr double kBeside = 4; // Samples on both sides.
        return (place_at(rachis_, along + kBeside) - place_at(rachis_, along - kBeside))
            .normalized();
    }

    // The leaflet beyond the end of the rachis that goes on most in its direction.
    void find_end()
    {
        constexpr double kMaxAngle_deg = 40;
        constexpr double kNearEnd = 0.96; // Of the rachis' length, from where on it is the end.
        auto const last = double(kSamples - 1);
        Vec2 const way = tangent(last);
        DrawnBlade* best = nullptr;
        double least_deg = kMaxAngle_deg;
        for (auto& blade : blades_) {
            double const angle_deg = std::abs(right_turn_deg(way, blade.way));
            bool const is_beyond = nearest_on(rachis_, blade.base).along > kNearEnd * last;
            // The rachis may run on as the leaflet's midrib.
            Vec2 const beyond = place_at(rachis_, last) - blade.base;
            bool const is_through = beyond.dot(blade.way) > 0
                && beyond.dot(blade.way) < 1.1 * blade.size
                && std::abs(cross(blade.way, beyond)) < 0.1 * blade.size;
            if ((is_beyond || is_through) && angle_deg < least_deg) {
                least_deg = angle_deg;
                best = &blade;
            }
        }
        if (best && blades_.size() > 1)
            best->is_end = true;
    }

    // Finds the foot of a leaflet: where its axis, extended backwards, meets the rachis' edge. If
    // it does not within some distance, the foot is the nearest place.
    void stand(DrawnBlade& blade) const
    {
        auto const near = nearest_on(rachis_, blade.base);
        blade.side
            = cross(tangent(near.along), blade.base - place_at(rachis_, near.along)) > 0 ? 1 : -1;
        blade.along = near.along;
        blade.foot = place_at(rachis_, near.along);
        double least = 3 * near.distance + 0.1;
        for (std::size_t i = 1; i < rachis_.size(); ++i) {
            Vec2 const step = rachis_[i] - rachis_[i - 1];
            if (!(step.norm() > 0))
                continue;
            Vec2 const edge = 0.5 * width_ * blade.side * left_of(step.normalized());
            // base - back * way = rachis + edge + share * step
            double const across = cross(step, blade.way);
            if (std::abs(across) < 1e-9)
                continue;
            Vec2 const from = blade.base - rachis_[i - 1] - edge;
            double const back = cross(step, from) / across;
            double const share = cross(blade.way, from) / cross(blade.way, step);
            if (back < 0 || back > least || share < 0 || share > 1)
                continue;
            least = back;
            blade.along = double(i - 1) + share;
            blade.foot = rachis_[i - 1] + share * step;
        }
    }

    // Leads the rachis on to a place. Returns the piece's length and turn.
    DrawnLeaf::Leaflet lead_to(Vec2 const& place, double knot)
    {
        Vec2 const way = place - at_;
        double length = way.norm() - knot / 2;
        bool const goes_on = length > kMinPiece && (is_first_ || way.dot(way_) > 0);
        // Two leaflets may stand at one place, and the first one where the petiole begins.
        Vec2 const next = goes_on ? Vec2(way.normalized()) : is_first_ ? tangent(0) : way_;
        length = std::max(goes_on ? length : kMinPiece, kMinPiece);
        DrawnLeaf::Leaflet made { .piece = length };
        if (is_first_)
            first_way_ = next;
        else
            made.turn_deg = right_turn_deg(way_, next);
        is_first_ = false;
        way_ = next;
        at_ += length * way_;
        return made;
    }

    DrawnLeaf::Leaflet next_leaflet(DrawnBlade const& blade)
    {
        auto made = lead_to(blade.foot, kLeafletKnot);
        Vec2 const stalk_begin
            = at_ + 0.5 * kLeafletKnot * way_ + 0.5 * width_ * blade.side * left_of(way_);
        at_ += kLeafletKnot * way_;
        made.angle_deg = right_turn_deg(way_, blade.way);
        // A leaflet stands on its own side.
        made.angle_deg
            = blade.side > 0 ? std::min(made.angle_deg, -0.01) : std::max(made.angle_deg, 0.01);
        made.stalk = std::max(kMinLeafletStalk,
                              (blade.base - stalk_begin).dot(blade.way) - kLeafletStalkEnd);
        made.size = blade.size;
        return made;
    }

    DrawnLeaf::Leaflet end_piece()
    {
        constexpr double kEndStalk = 0.02;
        auto const end = std::ranges::find_if(blades_, &DrawnBlade::is_end);
        if (end == blades_.end())
            return lead_to(rachis_.back(), 0);
        auto made = lead_to(end->base - (kEndStalk + kLeafletStalkEnd) * end->way, 0);
        made.angle_deg = right_turn_deg(way_, end->way);
        made.stalk = std::max(kMinLeafletStalk, (end->base - at_).dot(end->way) - kLeafletStalkEnd);
        made.size = end->size;
        return made;
    }

    RecognisedLeaf const& drawn_;
    double width_;
    Sheet sheet_;
    FlatLine rachis_;
    std::vector<DrawnBlade> blades_;
    Vec2 at_ = Vec2::Zero(); // End of the rachis as measured so far, and its direction there.
    Vec2 way_ = Vec2::UnitY();
    Vec2 first_way_ = Vec2::UnitY();
    bool is_first_ = true;
};

} // namespace

MeasuredRachis measure_rachis(RecognisedLeaf const& drawn, std::span<BladePlace const> places,
                              DrawnLeaf const& leaf)
{
    return RachisMeasurer(drawn, places, leaf).measure();
}

} // namespace tractus::leaf
