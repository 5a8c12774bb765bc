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

// Whether the view defines what ~letter draws.
bool has_organ(View const& view, char letter);

// The surface that ~letter draws; nullptr where it draws something else.
BezierSurface const* find_surface(View const& view, char letter);

// The materials and organ shapes that pieces of a drawing use, numbered so that the order in which
// they were used does not matter (see assemble_plant()).
class OrganCatalogue {
public:
    OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces);

    MaterialId material(std::uint8_t color) const { return materials_by_color_[color]; }
    OrganShapeId shape(TurtleDrawing::ShapeKey const& key) const
    {
        return shapes_by_key_.at(identity(key));
    }
    // How many shapes there are from that one on, of which each organ has one; 1 for most.
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

    // Identifies a shape; what has the turtle's colour is one shape for all colours of one
    // material.
    Identity identity(TurtleDrawing::ShapeKey const& key) const;
    void add_materials(View const& view, std::span<DrawnPiece const> pieces);
    std::vector<OrganShape> make_shapes(View const& view, Identity const& identity);
    OrganShape make_shape(View const& view, Identity const& identity);
    OrganShape make_surface(View const& view, Identity const& identity) const;
    MaterialId add_leaf(std::string const& name);

    std::array<MaterialId, 256> materials_by_color_ {}; // 0, bark, for what is not defined.
    MaterialId surface_material_ = 0; // Used where a colour has none; 0 until there is one.
    double unit_mm_;
    std::span<DrawnPiece const> pieces_;
    std::vector<Material> materials_;
    std::map<Identity, OrganShapeId> shapes_by_key_; // The first of each.
    std::map<char, std::size_t> variants_;           // Organs of grown leaves.
    std::vector<OrganShape> shapes_;
};

} // namespace tractus::lsystem
