#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/organ_file.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::lines {

// Brings a leaf from a file to a sketch, as lines that a pen might have drawn and goes on with.
// Like one that is drawn (DrawOrgan) it is borne by the whole plant if it is the first one, and
// else by the topmost layer of the stem in hand.
struct BringOrgan {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Vec3 at_mm = Vec3::Zero(); // Where on the tablet its base is; z is 0.
    std::string text {};       // As print_organ() writes it.
    scene::ItemId id = 0;      // The leaf's; those of its lines follow.
};

// A place on the tablet for the lines of a leaf from a file, beside what is drawn of the sketch:
// for BringOrgan::at_mm.
Vec3 place_beside(PenSketch const& sketch, SheetPlacement const& sheet, OrganFile const& organ);

} // namespace tractus::lines
