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

// Returns true if the view defines an organ or a surface for the symbol ~letter.
bool has_organ(View const& view, char letter);

// Returns the surface that the symbol ~letter draws; nullptr if it draws something else.
BezierSurface const* find_surface(View const& view, char letter);

// The materials and organ shapes that the pieces of a drawing use. Their numbering does not depend
// on the order in which the pieces use them (see assemble_plant()).
class OrganCatalogue {
public:
    OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces);

    MaterialId material(std::uint8_t color) const { return materials_by_color_[color]; }
    OrganShapeId shape(TurtleDrawing::ShapeKey const& key) const
    {
        return shapes_by_key_.at(identity(key));
    }
    // Returns the number of consecutive shapes, from shape() on, of which each organ uses one: 1,
    // or the number of grown leaves.
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

    // Returns the identity of a shape. A shape in the turtle's colour is the same for all colours
    // that have one material.
    Identity identity(TurtleDrawing::ShapeKey const& key) const;
    void add_materials(View const& view, std::span<DrawnPiece const> pieces);
    std::vector<OrganShape> make_shapes(View const& view, Identity const& identity);
    OrganShape make_shape(View const& view, Identity const& identity);
    OrganShape make_surface(View const& view, Identity const& identity) const;
    MaterialId add_leaf(std::string const& name);

    // Material of each turtle colour; for undefined colours 0, which is bark.
    std::array<MaterialId, 256> materials_by_color_ {};
    // Material of surfaces whose colour has none; 0 as long as none is needed.
    MaterialId surface_material_ = 0;
    double unit_mm_;
    std::span<DrawnPiece const> pieces_;
    std::vector<Material> materials_;
    std::map<Identity, OrganShapeId> shapes_by_key_; // First shape of each identity.
    // Number of grown leaves of each organ letter that has any.
    std::map<char, std::size_t> variants_;
    std::vector<OrganShape> shapes_;
};

} // namespace tractus::lsystem
