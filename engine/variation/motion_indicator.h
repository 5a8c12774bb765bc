#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// A line drawn in space that represents an influence on growth: its direction is that of the
// influence, its length gives the strength. Wind is drawn sideways, sunlight upwards, rain
// downwards (Streit 2006, section 4.4). World frame.
struct MotionIndicator {
    Vec3 start_mm = Vec3::Zero();
    Vec3 end_mm = Vec3::Zero();

    enum class Kind {
        Push, // Pushes all tips in the direction from start to end.
        // A lamp at the end: every branch is attracted to it from its own position (phototropism),
        // with the strength given by the line's length.
        Light,
    };
    Kind kind = Kind::Push;

    // Limits the effect to these segments and their descendants; empty: the whole plant.
    std::vector<SegmentId> below {};

    // Limits the effect to the surroundings of the line: full on the line, it falls to nothing at
    // this distance (millimetres of the displayed plant, world frame). No value: no limit.
    std::optional<double> reach_mm {};

    // True if the segments in `below` no longer exist in the plant. Such an indicator is kept,
    // since the branch may come back.
    bool is_orphaned = false;

    bool is_local() const { return !below.empty() || reach_mm || kind == Kind::Light; }
};

// Makes an indicator from the first and the last tip of a stroke. Fails, in one sentence, if the
// stroke has no tips or one of the two is not finite. A stroke that ends where it began is valid
// and has no effect.
Result<MotionIndicator> motion_indicator(Stroke const& stroke);

// Fails, in one sentence, if an end is not finite, a reach is not above 0, or a segment is not in
// the plant.
Result<void> check_indicator(Plant const& plant, MotionIndicator const& indicator);

// Returns the index of the indicator whose line is nearest to `point_mm`, or no value if none is
// within `finger_mm`.
std::optional<std::size_t> nearest_indicator(std::span<MotionIndicator const> indicators,
                                             Vec3 const& point_mm, double finger_mm);

// Weight of an indicator at a distance from its line: falls smoothly from 1 on the line to 0 at
// `reach_mm`; always 1 without a reach.
double falloff(MotionIndicator const& indicator, double distance_mm);

// Distance of a point from the indicator's line segment.
double distance_mm(MotionIndicator const& indicator, Vec3 const& point_mm);

} // namespace tractus::variation
