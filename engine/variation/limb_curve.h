#pragma once

#include "engine/variation/limb.h"

#include <span>
#include <vector>

namespace tractus::variation {

// The curve of a limb by arc length. It consists of the drawn points and, if these begin off the
// parent axis, of a short curve before them that begins at the seat (the origin).
class LimbCurve {
public:
    // `points` must contain at least two distinct points.
    LimbCurve(std::span<LimbPoint const> points, LimbAttachment const& seat);

    double length_mm() const { return length_to_mm_.back(); }

    // Share of the limb's length at which the drawn points begin.
    double drawn_from() const { return drawn_from_; }

    // Place and width at a share of the limb's length, from 0 to 1.
    LimbPoint at(double share) const;

    // Unit vector along the chord from `reach` before `share` to `reach` after it. Both are shares
    // of the limb's length.
    Vec3 direction(double share, double reach) const;

private:
    void add(LimbPoint const& point);
    void join(std::span<LimbPoint const> points, LimbAttachment const& seat);

    std::vector<LimbPoint> points_;
    std::vector<double> length_to_mm_; // Arc length from the limb's base to each point.
    double drawn_from_ = 0;
};

} // namespace tractus::variation
