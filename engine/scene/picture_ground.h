#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/scene/back_picture.h"

#include <optional>

namespace tractus::scene {

// Refuses, as the user's fault, what is not finite or out of range, a top that is not above its
// foot, and a foot that is not below the horizon.
Result<void> check_ground(PictureGround const& ground);

// Where something stands that is upright on the level ground of a picture.
struct GroundPlace {
    // On the ground: to the right of the picture's middle, and how far behind the thing of known
    // height.
    double right_m = 0;
    double behind_m = 0;
    double m_per_mm = 0; // Its true size by that on the sheet.
};

// From its foot on the sheet. The camera looks level and sees so many metres below the horizon as
// it is high, at every distance: so size and place to the side follow from horizon and known
// height alone. How far away it is follows from the width of the view, which nobody gives: 53
// degrees, that of a usual lens. Without a horizon everything is as far away as the known height.
//
// No value: no height is known. Fails, as the user's fault, for a foot that is not below the
// horizon.
Result<std::optional<GroundPlace>> place_on_ground(BackPicture const& picture, Vec2 const& foot_mm);

// A place on the sheet as PictureGround has it.
Vec2 on_picture(PicturePlace const& place, Vec2 const& sheet_mm);

} // namespace tractus::scene
