#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus {

// Reads a skeleton from a PLY file, ASCII or binary: vertices with x, y, z and perhaps radius, and
// edges that name two of them, as lists or as two numbers. AdTree writes such (Du et al. 2019,
// "AdTree: accurate, detailed, and automatic modelling of laser-scanned trees"). +z is up; lengths
// as millimetres_per_unit() says (measured_plant.h). Root, axes and, where vertices have no radius,
// radii as plant_from_lines() finds them (skeleton_lines.h).
//
// Refuses, in a sentence that begins with `name`, what is no PLY, a file that ends too early, edges
// to vertices that are not there, and a file without edges.
Result<Plant> parse_ply_skeleton(std::string const& name, std::span<std::byte const> bytes);

} // namespace tractus
