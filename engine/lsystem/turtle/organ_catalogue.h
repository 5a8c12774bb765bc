#pragma once

#include "engine/lsystem/turtle/plant_assembly.h"
#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/view/view.h"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tractus::lsystem {

// Returns true if the view defines an organ or a surface for ~letter.
bool has_organ(View const& view, char letter);

// Returns the surface that ~letter draws; nullptr if it draws something else.
BezierSurface const* find_surface(View const& view, char letter);

// Materials and organ shapes used by the pieces of a drawing. Their numbering does not depend on
// the order in which they were used (see assemble_plant()).
class OrganCatalogue {
public:
    OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces);

    MaterialId material(std::uint8_t color) const { return materials_by_color_[color]; }
    OrganShapeId shape(TurtleDrawing::ShapeKey const& key) const
    {
        return shapes_by_key_.at(identity(key));
    }
    // Number of consecutive shapes, from shape() on, of which each organ uses one; usually 1.
    std::size_t variants(TurtleDrawing::ShapeKey const& key) const;

    std::vector<Material> take_materials() { return std::move(materials_); }
    std::vector<OrganShape> take_shapes() { return std::move(shapes_); }

private:
    struct Identity {
        char letter = 0;
        OrganShape::Kind kind = OrganShape::Kind::Blade;
        MaterialId material = 0;
        std::uint32_t patch = 0;

        auto operator<=>(Identity const&) const = default;
    };

    // Identity of a shape. A shape in the turtle's colour is the same for all colours of one
    // material.
    Identity identity(TurtleDrawing::ShapeKey const& key) const;
    void add_materials(View const& view, std::span<DrawnPiece const> pieces);
    std::vector<OrganShape> make_shapes(View const& view, Identity const& identity);
    OrganShape make_shape(View const& view, Identity const& identity);
    OrganShape make_surface(View const& view, Identity const& identity) const;
    MaterialId add_leaf(std::string const& name);

    // Material of each turtle colour; 0, bark, for undefined colours.
    std::array<MaterialId, 256> materials_by_color_ {};
    // Material of surfaces whose colour has none; 0 until it is needed.
    MaterialId surface_material_ = 0;
    double unit_mm_;
    std::span<DrawnPiece const> pieces_;
    std::vector<Material> materials_;
    std::map<Identity, OrganShapeId> shapes_by_key_; // First shape of each identity.
    std::map<char, std::size_t> variants_; // Number of grown leaves for each organ letter.
    std::vector<OrganShape> shapes_;
};

} // namespace tractus::lsystem
