#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"

#include <string_view>

namespace tractus::render {

// Decodes a PNG or JPEG image of at most 100 megapixels. A photograph is turned upright if the
// camera stored its orientation. Images without alpha become opaque. Fails with a user error whose
// message does not contain the file's name. Safe for arbitrary bytes: sizes are checked before
// memory is allocated.
Result<Image> read_picture(std::string_view bytes);

} // namespace tractus::render
