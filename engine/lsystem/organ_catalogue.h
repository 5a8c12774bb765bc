#pragma once

#include "engine/lsystem/drawing.h"
#include "engine/lsystem/plant_assembly.h"
#include "engine/lsystem/view.h"

#include <array>
#include <map>
#include <span>
#include <tuple>
#include <vector>

namespace tractus {

// Whether the view defines what ~letter draws.
bool has_organ(View const& view, char letter);

// The materials and organ shapes that pieces of a drawing use, numbered so that the order in which
// they were used does not matter (see assemble_plant()).
class OrganCatalogue {
public:
    OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces);

    MaterialId material(std::uint8_t color) const { return materials_by_color_[color]; }
    OrganShapeId shape(Drawing::ShapeKey const& key) const
    {
        return shapes_by_key_.at(identity(key));
    }

    std::vector<Material> take_materials() { return std::move(materials_); }
    std::vector<OrganShape> take_shapes() { return std::move(shapes_); }

private:
    using Identity = std::tuple<char, OrganShape::Kind, MaterialId>;

    // Balls and discs of one material are one shape.
    Identity identity(Drawing::ShapeKey const& key) const
    {
        return { key.letter, key.kind, key.letter != 0 ? MaterialId { 0 } : material(key.color) };
    }
    void add_materials(View const& view, std::span<DrawnPiece const> pieces);
    OrganShape make_shape(View const& view, Identity const& identity);

    std::array<MaterialId, 256> materials_by_color_ {}; // 0, bark, for what is not defined.
    std::vector<Material> materials_;
    std::map<Identity, OrganShapeId> shapes_by_key_;
    std::vector<OrganShape> shapes_;
};

} // namespace tractus
