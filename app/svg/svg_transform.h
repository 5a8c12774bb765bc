#pragma once

#include "engine/base/vectors.h"

#include <optional>
#include <string_view>

namespace tractus::svg {

// An SVG attribute "transform": what is before it in the text is done last. No value if it is none.
std::optional<Eigen::Affine2d> parse_svg_transform(std::string_view text);

} // namespace tractus::svg
