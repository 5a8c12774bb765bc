#pragma once

#include "app/batch/pictures.h"
#include "engine/base/result.h"
#include "engine/export/billboard.h"

namespace tractus::batch {

// Renders a plant from eight horizontal directions, as pictures of 256 by 256 pixels.
Result<exports::Billboard> draw_billboard(PictureMaker& pictures, mesh::Mesh const& mesh);

} // namespace tractus::batch
