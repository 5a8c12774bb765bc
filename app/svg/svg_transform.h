#pragma once

#include "engine/base/vectors.h"

#include <optional>
#include <string_view>

namespace tractus::svg {

// Parses the SVG attribute "transform"; transforms apply from right to left. No value if it is
// invalid.
std::optional<Eigen::Affine2d> parse_svg_transform(std::string_view text);

} // namespace tractus::svg
