#pragma once

#include "app/render/image.h"
#include "engine/base/result.h"

#include <string_view>

namespace tractus::render {

// Reads a PNG or JPEG picture of at most 100 megapixels, upright as the camera that took it says;
// one without alpha is opaque. Fails, as the user's fault, in a sentence without the file's name.
// Any bytes are safe to give, and sizes that they claim are looked at before memory is taken.
Result<Image> read_picture(std::string_view bytes);

} // namespace tractus::render
