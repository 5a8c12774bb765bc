#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// A line drawn in space that says where an influence pushes, and by its length how much: wind is
// drawn sideways, sunlight upwards, rain downwards (Streit 2006 section 4.4). World frame.
struct MotionIndicator {
    Vec3 start_mm = Vec3::Zero();
    Vec3 end_mm = Vec3::Zero();

    enum class Kind {
        Push,  // Everything is pushed the way from start to end.
        Light, // A lamp at the end: every branch is drawn towards it (phototropism), from wherever
               // it is; the line's length says how much.
    };
    Kind kind = Kind::Push;

    // Acts only on these segments and all that they bear; none: on the whole plant.
    std::vector<SegmentId> below {};

    // Acts only around the line: fully on it, and falling to nothing at this distance, in the world
    // as the plant is shown there. No value: everywhere alike.
    std::optional<double> reach_mm {};

    // The plant has lost what it acts on, so it acts on nothing. Kept, since the branch may come
    // back.
    bool is_orphaned = false;

    bool is_local() const { return !below.empty() || reach_mm || kind == Kind::Light; }
};

// Only the ends of the drawn stroke count. Refuses, in a sentence, a stroke without tips or with an
// end that is not finite. A stroke that ends where it began pushes nowhere, and is fine.
Result<MotionIndicator> motion_indicator(Stroke const& stroke);

// Refuses, in a sentence, ends that are not finite, a reach that is not above 0, and a segment that
// is not in the plant.
Result<void> check_indicator(Plant const& plant, MotionIndicator const& indicator);

// The indicator whose line passes nearest to `point_mm`: its number in `indicators`. No value if
// none is within `finger_mm`.
std::optional<std::size_t> nearest_indicator(std::span<MotionIndicator const> indicators,
                                             Vec3 const& point_mm, double finger_mm);

// How much of an indicator is left at a distance from its line, 1 to 0: smooth, and 0 at its reach.
double falloff(MotionIndicator const& indicator, double distance_mm);

// The distance of a point from the line between the ends.
double distance_mm(MotionIndicator const& indicator, Vec3 const& point_mm);

} // namespace tractus::variation
