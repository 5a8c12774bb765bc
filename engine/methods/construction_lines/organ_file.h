#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/organ_surface.h"
#include "engine/methods/construction_lines/sketch_organ.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace tractus::lines {

// A leaf drawn in three views, as stored in a file (.organ) so that other plants can use it.
struct OrganFile {
    OrganViews views {};
    // Red, green and blue of the leaf, from 0 to 1; no value: the default colour of leaves.
    std::optional<Vec3> color {};
    std::shared_ptr<std::string const> picture {}; // A PNG file, see OrganSurface::picture.
};

// Parses a colour "#rrggbb" (hexadecimal). Fails with a user error for other text.
Result<Vec3> parse_color(std::string_view text);

// Reads text in this format, in millimetres as in OrganViews; -- begins a comment:
//
//   tractus-organ 1
//   color #c05080
//   left 0 0  -6 20  0 40     -- from base to tip
//   right 0 0  6 20  0 40
//   midrib 0 0  20 8  40 0
//   section 0 0  6 -1  12 0
//   picture iVBORw0KGgo…      -- a PNG file in base64, in place of the colour
//
// Lines may be missing, except that one side is required. Fails with a user error if the text is
// invalid; the message gives `name`, the number of the line and what to write. Also fails if the
// views give no surface, or one without breadth.
Result<OrganFile> parse_organ(std::string_view text, std::string const& name);

// Computes the surface of a leaf. Fails like organ_surface().
Result<OrganSurface> surface_of(OrganFile const& organ);

// Returns text that parse_organ() reads back as the same leaf.
std::string print_organ(OrganFile const& organ);

// Returns a drawn leaf, rounded to a thousandth of a millimetre, with its base at the origin. Fails
// like views_of().
Result<OrganFile> organ_file(SketchOrgan const& organ);

} // namespace tractus::lines
