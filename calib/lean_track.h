#pragma once

#include "calib/rig.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <deque>
#include <optional>

namespace tractus::calib {

// A pen's lean: how far aside a point is that lies a millimetre up the pen, towards +x and +y. Its
// length is the sine of the angle from upright.
//
// A tilt is two angles (HID Usage Tables, page 0x0D, "X Tilt" and "Y Tilt"): X's between the plane
// of Y and Z and the plane of Y and the pen, Y's likewise. So the pen lies along (tan x, tan y, 1).
// The tables count Y's towards the user; PenSample has it turned round, away from the user.
Vec2 lean_of(Vec2 const& tilt_rad);

// The last leans of a pen, smoothed. Tablets tell tilts in whole degrees, and none too steadily;
// ten millimetres up the pen a degree is 0.17 mm. So the lean at an instant is the value of a
// straight line through those around it, fitted as HeightTrack does it, over twice the time:
// nobody turns a pen as quickly as a carriage moves.
class LeanTrack {
public:
    // Half the width of the fit.
    static constexpr Duration kHalfWidth = std::chrono::milliseconds(40);

    // How much of the past is kept.
    explicit LeanTrack(Duration memory)
        : memory_(memory)
    {
    }

    // A sample that tells no tilt is left out. Where times go back, all before it is forgotten.
    void add(drivers::PenSample const& sample);

    // The lean at `time`, which must be that of a sample; no value where that one told no tilt, or
    // is older than the memory.
    std::optional<Vec2> at(Timestamp time) const;

private:
    struct Moment {
        Timestamp time {};
        Vec2 lean = Vec2::Zero();
    };

    Duration memory_;
    std::deque<Moment> moments_; // In time order.
};

// Where the nib of a pen is, in the tablet frame, by the rig's coil height: the sample's place less
// what its lean, of the track, makes it seem to be aside.
Vec2 nib_mm(drivers::PenSample const& sample, LeanTrack const& leans, Rig const& rig);

} // namespace tractus::calib
