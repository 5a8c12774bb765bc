#include "engine/lsystem/organ_catalogue.h"

#include <algorithm>
#include <set>

namespace tractus {

// nullptr: the view has none.
static OrganDefinition const* find_organ(View const& view, char letter)
{
    auto const found = std::find_if(view.organs.begin(), view.organs.end(),
                                    [&](auto const& organ) { return organ.letter == letter; });
    return found != view.organs.end() ? &*found : nullptr;
}

bool has_organ(View const& view, char letter)
{
    return find_organ(view, letter) != nullptr;
}

OrganCatalogue::OrganCatalogue(View const& view, double unit_mm, std::span<DrawnPiece const> pieces)
{
    add_materials(view, pieces);
    for (auto const& piece : pieces)
        for (auto const& key : piece.drawing.shape_keys)
            shapes_by_key_.try_emplace(identity(key));
    for (auto& [key, id] : shapes_by_key_) {
        id = static_cast<OrganShapeId>(shapes_.size());
        auto shape = make_shape(view, key);
        shape.length_mm *= unit_mm;
        shape.width_mm *= unit_mm;
        shape.petiole_mm *= unit_mm;
        shapes_.push_back(std::move(shape));
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
            if (key.letter == 0)
                used.insert(key.color);
            else if (auto const* const organ = find_organ(view, key.letter))
                used.insert(organ->shape.material);
    }
    materials_.emplace_back(); // Bark.
    for (auto const color : used)
        if (auto const defined = view.materials.find(color);
            defined != view.materials.end() && color >= 0 && color < 256) {
            materials_by_color_[static_cast<std::size_t>(color)]
                = static_cast<MaterialId>(materials_.size());
            materials_.push_back(defined->second);
        }
}

OrganShape OrganCatalogue::make_shape(View const& view, Identity const& identity)
{
    auto const& [letter, kind, surface] = identity;
    OrganShape shape;
    if (letter == 0) {
        shape.name = kind == OrganShape::Kind::Ball ? "ball" : "disc";
        shape.kind = kind;
        shape.material = surface;
        shape.length_mm = 1;
        shape.width_mm = 1;
    } else if (auto const* const organ = find_organ(view, letter)) {
        shape = organ->shape;
        shape.material = material(static_cast<std::uint8_t>(shape.material));
    } else {
        shape.name = std::string("leaf ") + letter;
        shape.length_mm = 1;
        shape.width_mm = 0.5;
        shape.material = static_cast<MaterialId>(materials_.size());
        Material leaf;
        leaf.name = shape.name;
        leaf.kind = Material::Kind::Leaf;
        leaf.base_color = { 0.30f, 0.48f, 0.17f };
        leaf.translucency = 0.4f;
        materials_.push_back(leaf);
    }
    return shape;
}

} // namespace tractus
