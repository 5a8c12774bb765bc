#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Multiscale tree graphs (MTG), a file format of botanists for plant architecture (Godin and
// Caraglio 1998, "A multiscale model of plant topological structures"; syntax: OpenAlea's MTG User
// Guide).

// Writes a plant: class P for the whole, which has all trunks as its components, A for axes, S for
// segments, L for leaves, F for flowers and petals, O for other organs. All but P and A have the
// columns XX, YY and ZZ (the upper end of a segment, or the attachment of an organ; plant frame)
// and Length; S also has TopDiameter and BottomDiameter. All are in millimetres. An S of length 0
// is the base of an axis on the ground.
//
// Organs are attached (+) to their segment, or to the base of the first axis if they are on the
// ground. They have further columns: Width; Depth, if it differs from Width (mtg_organs.h);
// Petiole, if there is one; DirectionX, Y and Z along the organ; NormalX, Y and Z out of its upper
// side; and Shape, the kind of shape and its number. These are written with six digits, positions
// with nine. Polygons, materials and the shapes themselves are not written.
void write_mtg(std::ostream& out, Plant const& plant);

struct MtgPlant {
    Plant plant {};
    // Messages to the user about data in the file that could not be added to the plant.
    std::vector<std::string> warnings {};
};

// Reads a plant from the entities that have a position in the columns XX, YY and ZZ. The position
// is the upper end of the entity. The diameter is read from a column TopDiameter, TopDia, Diameter,
// diam or similar, or half of it from the column radius. Entities without a position only
// contribute to the topology. Lengths are in millimetres if a comment says so, as in the output of
// write_mtg(); otherwise as guessed by millimetres_per_unit() (measured_plant.h).
//
// Classes Organ, Leaf, Flower, Fruit and Bud are organs, and so are L, F and O in files that have
// organ columns. Organs with a position, Length and Direction become part of the plant, unless they
// are larger than 10 km or further than that from its base. The others are counted in a warning.
//
// Fails, in a sentence that begins with `name` and the line, if the text is not an MTG, an entity
// has no parent, or no entity has a position.
Result<MtgPlant> parse_mtg_with_warnings(std::string const& name, std::string_view text);

// Like parse_mtg_with_warnings(), without the warnings.
Result<Plant> parse_mtg(std::string const& name, std::string_view text);

} // namespace tractus
