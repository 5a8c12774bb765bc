#include "engine/lsystem/turtle/organ_catalogue.h"

#include <algorithm>
#include <set>

namespace tractus::lsystem {

// Finds the definition of an organ by its letter; nullptr if the view does not define it.
static OrganDefinition const* find_organ(View const& view, char letter)
{
    auto const found = std::find_if(view.organs.begin(), view.organs.end(),
                                    [&](auto const& organ) { return organ.letter == letter; });
    return found != view.organs.end() ? &*found : nullptr;
}

bool has_organ(View const& view, char letter)
{
    return find_organ(view, letter) != nullptr || find_surface(view, letter) != nullptr;
}

BezierSurface const* find_surface(View const& view, char letter)
{
    auto const found = view.surfaces.find(letter);
    return found != view.surfaces.end() && !find_organ(view, letter) ? &found->second : nullptr;
}

OrganCatalogue::Identity OrganCatalogue::identity(TurtleDrawing::ShapeKey const& key) const
{
    if (key.letter != 0 && key.kind != OrganShape::Kind::Surface)
        return { key.letter, key.kind, 0, 0 };
    auto const own = material(key.color);
    bool const is_plain = own == 0 && key.kind == OrganShape::Kind::Surface;
    return { key.letter, key.kind, is_plain ? surface_material_ : own, key.patch };
}

OrganCatalogue::OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces)
    : unit_mm_(unit_mm)
    , pieces_(pieces)
{
    add_materials(view, pieces);
    for (auto const& piece : pieces)
        for (auto const& key : piece.drawing.shape_keys)
            shapes_by_key_.try_emplace(identity(key));
    for (auto& [key, id] : shapes_by_key_) {
        id = static_cast<OrganShapeId>(shapes_.size());
        for (auto& shape : make_shapes(view, key)) {
            shape.length_mm *= unit_mm;
            shape.width_mm *= unit_mm;
            shape.petiole_mm *= unit_mm;
            shapes_.push_back(std::move(shape));
        }
    }
}

void OrganCatalogue::add_materials(View const& view, std::span<DrawnPiece const> pieces)
{
    std::set<int> used;
    for (auto const& piece : pieces) {
        for (std::size_t color = 0; color < piece.drawing.has_color.size(); ++color)
            if (piece.drawing.has_color[color])
                used.insert(static_cast<int>(color));
        for (auto const& key : piece.drawing.shape_keys)
            if (key.letter == 0 || key.kind == OrganShape::Kind::Surface)
                used.insert(key.color);
            else if (auto const* const organ = find_organ(view, key.letter))
                used.insert(organ->shape.material);
    }
    materials_.emplace_back(); // Material 0 is bark.
    for (auto const color : used)
        if (auto const defined = view.materials.find(color);
            defined != view.materials.end() && color >= 0 && color < 256) {
            materials_by_color_[static_cast<std::size_t>(color)]
                = static_cast<MaterialId>(materials_.size());
            materials_.push_back(defined->second);
        }
    // Surfaces are mostly leaves, so those without a material get a leaf's material instead of
    // bark.
    for (auto const& piece : pieces)
        for (auto const& key : piece.drawing.shape_keys)
            if (key.kind == OrganShape::Kind::Surface && material(key.color) == 0
                && surface_material_ == 0)
                surface_material_ = add_leaf("surface");
}

MaterialId OrganCatalogue::add_leaf(std::string const& name)
{
    Material leaf;
    leaf.name = name;
    leaf.kind = Material::Kind::Leaf;
    leaf.base_color = { 0.30f, 0.48f, 0.17f };
    leaf.translucency = 0.4f;
    materials_.push_back(leaf);
    return static_cast<MaterialId>(materials_.size() - 1);
}

// Makes the shape of a surface: its patches in millimetres, and their bounding box in turtle units,
// as for other shapes.
OrganShape OrganCatalogue::make_surface(View const& view, Identity const& identity) const
{
    OrganShape shape;
    shape.kind = OrganShape::Kind::Surface;
    shape.material = identity.material;
    if (identity.patch > 0) {
        shape.name = "patch " + std::to_string(identity.patch);
        // Strings whose turtle makes patches are never divided, so there is only one piece.
        shape.patches = { pieces_.front().drawing.patches[identity.patch - 1] };
    } else {
        shape.name = std::string("surface ") + identity.letter;
        shape.patches = find_surface(view, identity.letter)->patches;
    }
    Eigen::AlignedBox3d box;
    for (auto& patch : shape.patches)
        for (auto& point : patch.control) {
            box.extend(point);
            point *= unit_mm_;
        }
    shape.width_mm = box.sizes().x();
    shape.length_mm = box.sizes().y();
    auto const kind = materials_[shape.material].kind;
    shape.has_back = kind != Material::Kind::Leaf && kind != Material::Kind::Petal;
    return shape;
}

std::size_t OrganCatalogue::variants(TurtleDrawing::ShapeKey const& key) const
{
    auto const found = variants_.find(identity(key).letter);
    bool const is_surface = key.kind == OrganShape::Kind::Surface;
    return found == variants_.end() || is_surface ? 1 : found->second;
}

std::vector<OrganShape> OrganCatalogue::make_shapes(View const& view, Identity const& identity)
{
    auto const* const organ = identity.letter != 0 && identity.kind != OrganShape::Kind::Surface
        ? find_organ(view, identity.letter)
        : nullptr;
    if (!organ || organ->leaves.empty())
        return { make_shape(view, identity) };
    auto leaves = organ->leaves;
    for (auto& leaf : leaves)
        leaf.material = material(static_cast<std::uint8_t>(leaf.material));
    variants_[identity.letter] = leaves.size();
    return leaves;
}

OrganShape OrganCatalogue::make_shape(View const& view, Identity const& identity)
{
    if (identity.kind == OrganShape::Kind::Surface)
        return make_surface(view, identity);
    OrganShape shape;
    if (identity.letter == 0) {
        shape.name = identity.kind == OrganShape::Kind::Ball ? "ball" : "disc";
        shape.kind = identity.kind;
        shape.material = identity.material;
        shape.length_mm = 1;
        shape.width_mm = 1;
    } else if (auto const* const organ = find_organ(view, identity.letter)) {
        shape = organ->shape;
        shape.material = material(static_cast<std::uint8_t>(shape.material));
    } else {
        shape.name = std::string("leaf ") + identity.letter;
        shape.length_mm = 1;
        shape.width_mm = 0.5;
        shape.material = add_leaf(shape.name);
    }
    return shape;
}

} // namespace tractus::lsystem
