#pragma once

#include "engine/variation/limb.h"

#include <span>
#include <vector>

namespace tractus::variation {

// The curve of a limb by arc length: the drawn points, and before them, if they begin off the
// parent axis, a short curve that joins them to the seat at the origin.
class LimbCurve {
public:
    // `points`: at least two distinct ones.
    LimbCurve(std::span<LimbPoint const> points, LimbAttachment const& seat);

    double length_mm() const { return length_to_mm_.back(); }

    // Share of the limb's length at which the drawn points begin.
    double drawn_from() const { return drawn_from_; }

    // Place and width at a share of the length, from 0 to 1.
    LimbPoint at(double share) const;

    // Direction of the chord from `reach` before a share of the length to `reach` after it, both
    // shares of the length; unit vector.
    Vec3 direction(double share, double reach) const;

private:
    void add(LimbPoint const& point);
    void join(std::span<LimbPoint const> points, LimbAttachment const& seat);

    std::vector<LimbPoint> points_;
    std::vector<double> length_to_mm_; // Arc length from the limb's base to each point.
    double drawn_from_ = 0;
};

} // namespace tractus::variation
