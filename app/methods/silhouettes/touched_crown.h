#pragma once

#include "engine/base/result.h"
#include "engine/scene/back_picture.h"
#include "engine/stroke/stroke.h"

namespace tractus::silhouette {

// Traces the crown that a touch hits in the picture behind the drawing (picture_crown.h). Returns
// the crown's outline as if the pen had drawn it on the sheet. Fails with a user error if no crown
// is found there (find_crown_in_picture()), or the picture cannot be decoded.
Result<Stroke> outline_touched(scene::BackPicture const& picture, Stroke const& touch);

} // namespace tractus::silhouette
