#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/organ_file.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::lines {

// Edit: adds a leaf from a file to a sketch, as lines that can be edited like drawn ones. The
// sketch's first leaf is assigned to the whole plant, later leaves to the topmost layer of the
// current stem, as with DrawOrgan.
struct BringOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Vec3 at_mm = Vec3::Zero(); // Position of the leaf's base on the tablet; z is 0.
    std::string text {};       // Text of the leaf, as written by print_organ().
    scene::ItemId id = 0;      // Id of the leaf; its lines have the following ids.
};

// Returns a position on the tablet for BringOrgan::at_mm, at which the lines of a leaf from a file
// have free space beside the sketch.
Vec3 place_beside(PenSketch const& sketch, SheetPlacement const& sheet, OrganFile const& organ);

} // namespace tractus::lines
