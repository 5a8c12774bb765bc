#pragma once

#include "engine/base/vectors.h"

#include <optional>
#include <string_view>

namespace tractus::svg {

// Parses the SVG attribute "transform". Of several transforms, the last one applies first. No value
// if the text is invalid.
std::optional<Eigen::Affine2d> parse_svg_transform(std::string_view text);

} // namespace tractus::svg
