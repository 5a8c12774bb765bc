#pragma once

#include "engine/base/result.h"
#include "engine/scene/back_picture.h"
#include "engine/stroke/stroke.h"

namespace tractus::silhouette {

// The outline of the crown that a touch lies in, in the picture behind what is drawn
// (picture_crown.h), as if the pen had drawn it on the sheet. Fails, as the user's fault, like
// crown_in_picture(), and for a picture that cannot be read.
Result<Stroke> outline_touched(scene::BackPicture const& picture, Stroke const& touch);

} // namespace tractus::silhouette
