#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Multiscale tree graphs, in which botanists keep plants (Godin and Caraglio 1998, "A multiscale
// model of plant topological structures"; the file's syntax is in OpenAlea's MTG User Guide).

// Writes a plant: class P for each part that stands on the ground, A for its axes, S for segments,
// L for leaves, F for flowers and their petals, O for other organs. All but P and A have the
// columns XX, YY and ZZ (of a segment's upper end, of where an organ is attached; plant frame) and
// Length, S also TopDiameter and BottomDiameter; all in millimetres. An S of no length is the base
// of its axis on the ground.
//
// Organs stand on (+) the segment that bears them, those of the ground on the base of the first
// axis, and have the columns Width; Depth, where it is another than Width (mtg_organs.h); Petiole,
// if there is any; DirectionX, Y and Z along the organ and NormalX, Y and Z out of its upper side;
// Shape, the word of its form and the form's number. Six digits of them are written, and nine of
// where they are. Polygons, materials and forms are not in the file.
void write_mtg(std::ostream& out, Plant const& plant);

struct MtgPlant {
    Plant plant {};
    std::vector<std::string> warnings {}; // For people: what is in the file and not in the plant.
};

// Reads a plant from entities that have the columns XX, YY and ZZ; they are upper ends. A diameter
// is in one of the columns TopDiameter, TopDia, Diameter, diam and the like, or half of it in the
// column radius. Entities without a position only say what bears what. Lengths are millimetres
// where a comment says so, as in what write_mtg() writes; otherwise millimetres_per_unit()
// (measured_plant.h).
//
// Classes Organ, Leaf, Flower, Fruit and Bud are organs, and L, F and O in files that have the
// columns of organs. Those that have a position, a Length and a Direction that are numbers, of at
// most 10 km, are in the plant; the others are counted in a warning.
//
// Refuses, in a sentence that begins with `name` and the line, what is no MTG, entities that stand
// on none, and a plant without positions.
Result<MtgPlant> parse_mtg_with_warnings(std::string const& name, std::string_view text);

// Reads likewise, and drops the warnings.
Result<Plant> parse_mtg(std::string const& name, std::string_view text);

} // namespace tractus
