#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus {

// Reads a skeleton from an ASCII or binary PLY file: vertices with x, y, z and optionally a radius,
// and edges that connect two vertices, as lists or as two numbers. AdTree writes such files (Du et
// al. 2019, "AdTree: accurate, detailed, and automatic modelling of laser-scanned trees"). +z is
// up; the unit is guessed by millimetres_per_unit() (measured_plant.h). The root, the axes, and
// radii if the vertices have none, are determined by plant_from_lines() (skeleton_lines.h).
//
// Fails, in a sentence that begins with `name`, if the file is not a PLY, is truncated, has edges
// to missing vertices, or has no edges.
Result<Plant> parse_ply_skeleton(std::string const& name, std::span<std::byte const> bytes);

} // namespace tractus
