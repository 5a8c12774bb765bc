#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"

#include <string_view>

namespace tractus::render {

// Decodes a PNG or JPEG image of at most 100 megapixels and turns it upright as recorded by the
// camera. Images without alpha become opaque. Fails with a user error whose message lacks the
// file's name. Safe for arbitrary bytes; sizes are checked before memory is allocated.
Result<Image> read_picture(std::string_view bytes);

} // namespace tractus::render
