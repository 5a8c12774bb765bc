#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <string>
#include <string_view>

namespace tractus {

// Reads a quantitative structure model: a measured tree as cylinders, one in each line (Raumonen et
// al. 2013, "Fast automatic precision tree models from terrestrial laser scanner data").
//
// Columns are parted by commas, semicolons, tabs or blanks. A first line may name them, as
// TreeQSM's users do: start_x, start_y, start_z, either axis_x, axis_y, axis_z and length or end_x,
// end_y, end_z, radius, parent, and perhaps id, branch and extension, whatever their case and their
// underscores. Without such names they are TreeQSM's own: radius, length, start (3), axis (3),
// parent, extension, and others that differ from version to version. Parents and extensions are
// ids, or lines counted from 1; a number that is none, such as 0, is the ground, or no extension.
// +z is up; lengths as millimetres_per_unit() says (measured_plant.h).
//
// A cylinder reaches from where the one below it ends to its own end. An axis goes on where
// `extension` leads; in files without extensions where the branch is the same, or else, without
// that column, into the thickest.
//
// Refuses, in a sentence that begins with `name` and the line, numbers that are none, lines that
// are too short, and cylinders that stand on each other.
Result<Plant> parse_qsm(std::string const& name, std::string_view text);

} // namespace tractus
