#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/scene/back_picture.h"

#include <optional>

namespace tractus::scene {

// Fails with a user error if a value is not finite or out of range, the top is not above the foot,
// or the foot is not below the horizon.
Result<void> check_ground(PictureGround const& ground);

// Position and scale of an upright object on the level ground of a picture.
struct GroundPlace {
    // Position on the ground, in metres: to the right of the picture's centre, and behind the
    // object of known height.
    double right_m = 0;
    double behind_m = 0;
    double m_per_mm = 0; // Natural size, in metres, of one millimetre on the sheet at the object.
};

// Computes position and scale of an object from its foot on the sheet. The camera is assumed level,
// so at every distance the ground is as far below the horizon as the camera is high. Scale and
// lateral position therefore follow from the horizon and the known height alone. The distance also
// depends on the angle of view, which is unknown and assumed to be 53 degrees, that of a standard
// lens. Without a horizon, everything is taken to be as far away as the object of known height.
//
// Returns no value if no height is known. Fails with a user error if the foot is not below the
// horizon.
Result<std::optional<GroundPlace>> place_on_ground(BackPicture const& picture, Vec2 const& foot_mm);

// Converts a position on the sheet to the coordinates that PictureGround uses.
Vec2 on_picture(PicturePlace const& place, Vec2 const& sheet_mm);

} // namespace tractus::scene
