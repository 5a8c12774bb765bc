#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <string>
#include <string_view>

namespace tractus {

// Reads a quantitative structure model (QSM): a measured tree as cylinders, one per line (Raumonen
// et al. 2013, "Fast automatic precision tree models from terrestrial laser scanner data").
//
// Columns are separated by commas, semicolons, tabs or spaces. The first line may name them, as
// users of TreeQSM do: start_x, start_y, start_z, either axis_x, axis_y, axis_z and length or
// end_x, end_y, end_z, then radius, parent, and optionally id, branch and extension; case and
// underscores are ignored. Without names the order is TreeQSM's: radius, length, start (3), axis
// (3), parent, extension, and others that depend on the version. Parents and extensions refer to
// ids, or to lines counted from 1; a number that refers to no cylinder, such as 0, means the
// ground, or no extension. +z is up; the unit is guessed by millimetres_per_unit()
// (measured_plant.h).
//
// A segment reaches from the end of the parent cylinder to the cylinder's own end. An axis is
// continued by the `extension`; in files without extensions by the child of the same branch, or,
// without a column branch, by the thickest child.
//
// Fails, in a sentence that begins with `name` and the line, if a number is invalid, a line is too
// short, or the parents form a cycle.
Result<Plant> parse_qsm(std::string const& name, std::string_view text);

} // namespace tractus
