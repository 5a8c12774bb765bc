#pragma once

#include "engine/plant/measured_plant.h"
#include "engine/plant/plant.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus {

// Organs as rows of a multiscale tree graph (mtg.h): what its writer and its reader share.

// Classes L, F and O of the graph: leaves, flowers and their petals, all else.
enum class MtgOrganClass : std::uint8_t { Leaf, Flower, Other };

// One organ. Lengths and positions are in the file's unit, in the plant's frame.
struct MtgOrgan {
    MtgOrganClass kind = MtgOrganClass::Other;
    std::uint32_t node = kNone; // The node of the graph that bears it; kNone: the ground.
    Vec3 position = Vec3::Zero();
    Vec3 direction = Vec3::UnitY(); // Along its length; of any length but 0.
    Vec3 normal = Vec3::UnitZ();    // Out of its upper side.
    double length = 0;
    double width = 0;
    // What the width is along the normal: for a ball its size there, for a leaf how far it bends
    // out of its plane. No value: it is scaled there as across.
    std::optional<double> depth {};
    double petiole = 0; // Part of the length.
    // The word of its form, and a number that all organs of that form have. Not owned: the file's.
    std::string_view shape {};
};

// Columns of the features that organs have besides XX, YY and ZZ. Segments have Length, too.
constexpr std::array<std::string_view, 11> kMtgOrganColumns {
    "Length",     "Width",   "Depth",   "Petiole", "DirectionX", "DirectionY",
    "DirectionZ", "NormalX", "NormalY", "NormalZ", "Shape"
};

// L, F or O.
char mtg_symbol(MtgOrganClass kind);

// An organ of a plant as a row, without a node and a shape; and what its column Shape says.
MtgOrgan mtg_organ(Plant const& plant, Organ const& organ);
std::string mtg_shape_name(Plant const& plant, OrganShapeId shape);

// Where a file has the features of its organs.
class MtgOrganColumns {
public:
    // Finds them by the names of the columns from `first` on. No value for files that say nothing
    // of the direction of organs: then classes L, F and O may be anything.
    static std::optional<MtgOrganColumns> find(std::span<std::string_view const> names,
                                               std::size_t first);

    // No value where a row has no direction and no length that are numbers.
    std::optional<MtgOrgan> read(std::span<std::string_view const> cells) const;

private:
    std::array<std::optional<std::size_t>, kMtgOrganColumns.size()> columns_ {};
};

// Whether it is of a size and in a place that an organ of that plant can have: at most 10 km large
// and away. Lengths are in millimetres.
bool is_sound(MtgOrgan const& organ, Vec3 const& base_mm);

// Adds organs that are sound, with shapes and materials for them: one shape for all of a class that
// have the same `shape`, as large as the largest of them. Lengths are in millimetres.
//
// Forms that are not told by a few numbers, surfaces and grown leaves, become blades, and balls
// where they are no leaf and no flower.
void add_mtg_organs(MeasuredPlant& measured, std::span<MtgOrgan const> organs);

} // namespace tractus
