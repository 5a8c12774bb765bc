#pragma once

#include "calib/rig.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <deque>
#include <optional>

namespace tractus::calib {

// Returns a pen's lean: the horizontal displacement of a point 1 mm up the pen, towards +x and +y.
// Its length is the sine of the angle from upright.
//
// A tilt is two angles (HID Usage Tables, page 0x0D, "X Tilt" and "Y Tilt"): X Tilt is between the
// YZ plane and the plane through the Y axis and the pen, and Y Tilt correspondingly. The pen
// therefore has the direction (tan x, tan y, 1). The HID tables count Y Tilt towards the user;
// PenSample counts it away from the user.
Vec2 lean_of(Vec2 const& tilt_rad);

// Recent leans of a pen, smoothed. Tablets report tilts in whole degrees and with noise; ten
// millimetres up the pen, a degree is 0.17 mm. The lean at an instant is therefore the value of a
// line through the leans around it, fitted as in HeightTrack. The window is about twice as long as
// in HeightTrack, because a hand turns a pen more slowly than it moves a carriage.
class LeanTrack {
public:
    // Half the width of the time window of a fit.
    static constexpr Duration kHalfWidth = std::chrono::milliseconds(40);

    // `memory` is the time for which past leans are kept.
    explicit LeanTrack(Duration memory)
        : memory_(memory)
    {
    }

    // Adds a sample; one without a tilt is ignored. If times go back, all earlier samples are
    // forgotten.
    void add(drivers::PenSample const& sample);

    // Returns the lean at `time`, which must be the time of a sample; no value if that sample had
    // no tilt, or is older than the memory.
    std::optional<Vec2> at(Timestamp time) const;

private:
    struct Moment {
        Timestamp time {};
        Vec2 lean = Vec2::Zero();
    };

    Duration memory_;
    std::deque<Moment> moments_; // Leans in time order.
};

// Returns the position of a pen's nib in the tablet frame: the sample's position minus the
// displacement caused by its lean and the rig's coil height.
Vec2 nib_mm(drivers::PenSample const& sample, LeanTrack const& leans, Rig const& rig);

} // namespace tractus::calib
