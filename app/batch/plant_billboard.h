#pragma once

#include "app/batch/pictures.h"
#include "engine/base/result.h"
#include "engine/export/billboard.h"

namespace tractus::batch {

// Draws a plant from eight sides, at 256 by 256 pixels each.
Result<exports::Billboard> draw_billboard(PictureMaker& pictures, mesh::Mesh const& mesh);

} // namespace tractus::batch
