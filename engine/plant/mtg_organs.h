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

// Organs as rows of a multiscale tree graph (mtg.h), as shared by its writer and its reader.

// Classes L (leaf), F (flower or petal) and O (other organ) of the graph.
enum class MtgOrganClass : std::uint8_t { Leaf, Flower, Other };

// One organ. Lengths and positions are in the file's unit, in the plant's frame.
struct MtgOrgan {
    MtgOrganClass kind = MtgOrganClass::Other;
    std::uint32_t node = kNone; // The graph node that the organ is attached to; kNone: the ground.
    Vec3 position = Vec3::Zero();
    Vec3 direction = Vec3::UnitY(); // Direction from base to tip; any length except 0.
    Vec3 normal = Vec3::UnitZ();    // Normal of the upper side.
    double length = 0;
    double width = 0;
    // Extent along the normal: the size of a ball in that direction, or how far a leaf bends out of
    // its plane. No value: the organ is scaled along its normal as much as across its width.
    std::optional<double> depth {};
    double petiole = 0; // Length of the petiole, included in `length`.
    // The kind of shape and a number that identifies the shape, such as "blade-2". Points into the
    // text of the file.
    std::string_view shape {};
};

// Names of the columns of organs besides XX, YY and ZZ. Segments also have the column Length.
constexpr std::array<std::string_view, 11> kMtgOrganColumns {
    "Length",     "Width",   "Depth",   "Petiole", "DirectionX", "DirectionY",
    "DirectionZ", "NormalX", "NormalY", "NormalZ", "Shape"
};

// Returns the letter of the class in a file: L, F or O.
char mtg_symbol(MtgOrganClass kind);

// Returns the row of an organ, without `node` and `shape`; mtg_shape_name() returns its column
// Shape.
MtgOrgan mtg_organ(Plant const& plant, Organ const& organ);
std::string mtg_shape_name(Plant const& plant, OrganShapeId shape);

// Positions of the organ columns among the columns of a file.
class MtgOrganColumns {
public:
    // Finds the columns by name, from column `first` on. Returns no value if the file has no
    // columns for the direction of organs: then classes L, F and O may mean something else.
    static std::optional<MtgOrganColumns> find(std::span<std::string_view const> names,
                                               std::size_t first);

    // Reads the organ of a row. Returns no value if the row lacks a numeric direction or length.
    std::optional<MtgOrgan> read(std::span<std::string_view const> cells) const;

private:
    std::array<std::optional<std::size_t>, kMtgOrganColumns.size()> columns_ {};
};

// True if the organ is at most 10 km large and at most 10 km away from the plant's base. Lengths in
// millimetres.
bool is_plausible_organ(MtgOrgan const& organ, Vec3 const& base_mm);

// Adds the valid organs to the plant, with shapes and materials for them: one shape for all organs
// of a class with the same `shape`, sized for the largest of them. Lengths in millimetres.
//
// The file does not hold the form of surfaces and grown leaves. They become blades, or balls if the
// organ is neither a leaf nor a flower.
void add_mtg_organs(MeasuredPlant& measured, std::span<MtgOrgan const> organs);

} // namespace tractus
