#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace tractus {

// Multiscale tree graphs, in which botanists keep plants (Godin and Caraglio 1998, "A multiscale
// model of plant topological structures"; the file's syntax is in OpenAlea's MTG User Guide).

// Writes a plant: class P for each part that stands on the ground, A for its axes, S for segments,
// Organ for organs. S and Organ have the columns XX, YY, ZZ (of their upper end, plant frame), S
// also Length, and TopDiameter and BottomDiameter; all in millimetres. An S of no length is
// the base of its axis on the ground.
void write_mtg(std::ostream& out, Plant const& plant);

// Reads a plant from entities that have the columns XX, YY and ZZ; they are upper ends. A diameter
// is in one of the columns TopDiameter, TopDia, Diameter, diam and the like, or half of it in the
// column radius. Entities without a position only say what bears what; classes Organ, Leaf, Flower,
// Fruit and Bud are passed over. Lengths are millimetres where a comment says so, as in what
// write_mtg() writes; otherwise millimetres_per_unit() (measured_plant.h).
//
// Refuses, in a sentence that begins with `name` and the line, what is no MTG, entities that stand
// on none, and a plant without positions.
Result<Plant> parse_mtg(std::string const& name, std::string_view text);

} // namespace tractus
