#include "engine/methods/sketch_lsystem/stroke_resampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::sketch {

StrokeResampler::StrokeResampler(SegmentLengths lengths)
    : lengths_(std::move(lengths))
    , next_length_mm_(lengths_.first_mm.front())
    , most_nodes_(static_cast<std::size_t>(lengths_.most) + 1)
{
    nodes_mm_.reserve(most_nodes_);
}

bool StrokeResampler::is_full() const
{
    return nodes_mm_.size() == most_nodes_ || next_length_mm_ < lengths_.shortest_mm;
}

// The point where the line from `inside_mm`, in the ball, to `tip_mm`, outside it, crosses the
// sphere.
static Vec3 leave_ball(Vec3 const& center_mm, double radius_mm, Vec3 const& inside_mm,
                       Vec3 const& tip_mm)
{
    Vec3 const way = tip_mm - inside_mm;
    Vec3 const from_center = inside_mm - center_mm;
    double const a = way.squaredNorm();
    double const b = way.dot(from_center);
    double const c = from_center.squaredNorm() - radius_mm * radius_mm;
    double const share
        = a == 0 ? 0 : std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
    return inside_mm + share * way;
}

int StrokeResampler::push(Vec3 const& tip_mm)
{
    if (!tip_mm.allFinite())
        return 0;
    if (nodes_mm_.empty()) {
        nodes_mm_.push_back(tip_mm);
        last_tip_mm_ = tip_mm;
        return 0;
    }
    // Margin for rounding, so that a tip on the sphere counts as outside.
    constexpr double kOnSphere = 1 - 1e-9;
    int made = 0;
    Vec3 inside_mm = last_tip_mm_;
    while (!is_full() && (tip_mm - nodes_mm_.back()).norm() >= next_length_mm_ * kOnSphere) {
        inside_mm = leave_ball(nodes_mm_.back(), next_length_mm_, inside_mm, tip_mm);
        nodes_mm_.push_back(inside_mm);
        next_length_mm_ = length_after(lengths_, nodes_mm_.size() - 2, next_length_mm_);
        ++made;
    }
    last_tip_mm_ = tip_mm;
    return made;
}

std::vector<Vec3> resample_stroke(SegmentLengths const& lengths, std::span<Vec3 const> tips_mm)
{
    StrokeResampler resampler(lengths);
    for (auto const& tip_mm : tips_mm)
        resampler.push(tip_mm);
    return { resampler.nodes_mm().begin(), resampler.nodes_mm().end() };
}

std::vector<Vec3> resample_stroke(Rule const& rule, std::span<Vec3 const> tips_mm)
{
    return resample_stroke(lengths_of(rule), tips_mm);
}

} // namespace tractus::sketch
