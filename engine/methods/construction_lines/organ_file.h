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

// A leaf in three views, as a file (.organ) holds it for other plants.
struct OrganFile {
    OrganViews views {};
    std::optional<Vec3> color {}; // Red, green and blue from 0 to 1; no value: as leaves have it.
    std::shared_ptr<std::string const> picture {}; // OrganSurface::picture.
};

// "#rrggbb". Fails, as the user's fault, for other text.
Result<Vec3> parse_color(std::string_view text);

// Reads text of this form, millimetres as in OrganViews; what stands behind -- is for people:
//
//   tractus-organ 1
//   color #c05080
//   left 0 0  -6 20  0 40     -- from base to tip
//   right 0 0  6 20  0 40
//   midrib 0 0  20 8  40 0
//   section 0 0  6 -1  12 0
//   picture iVBORw0KGgo…      -- a PNG file in base 64, in place of the colour
//
// A line may be missing, but for one side. Fails, as the user's fault, with `name`, the number of
// the line and what to write; and for views that give no surface, or one without
// breadth.
Result<OrganFile> parse_organ(std::string_view text, std::string const& name);

// Fails like organ_surface().
Result<OrganSurface> surface_of(OrganFile const& organ);

// Such a text: read again it is the same leaf.
std::string print_organ(OrganFile const& organ);

// What is kept of a drawn leaf, to a thousandth of a millimetre: its base is at the origin. Fails
// like views_of().
Result<OrganFile> organ_file(SketchOrgan const& organ);

} // namespace tractus::lines
