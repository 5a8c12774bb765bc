#include "engine/scene/foliated_plant.h"

#include "engine/base/random.h"

#include <limits>
#include <map>
#include <optional>

namespace tractus::scene {

namespace {

constexpr std::uint32_t kLeafStream = 0x1eaf;

class FoliageSetter {
public:
    FoliageSetter(Plant const& plant, lsystem::LeafSheet const& sheet)
        : sheet_(sheet)
        , plant_(plant)
    {
    }

    Plant run()
    {
        // Appends the new shapes. Where their ids would exceed the range of OrganShapeId, leaves
        // keep their shape.
        auto const own = plant_.organ_shapes.size();
        std::vector<std::optional<OrganShapeId>> first(own);
        for (std::size_t i = 0; i < own; ++i)
            if (is_leaf(plant_, plant_.organ_shapes[i]) && has_room())
                first[i] = add_leaves(plant_.organ_shapes[i]);
        for (std::size_t i = 0; i < plant_.organs.size(); ++i) {
            auto& organ = plant_.organs[i];
            if (!first[organ.shape])
                continue;
            Random random({ 0, kLeafStream, static_cast<std::uint32_t>(i) });
            auto const number = random.uniform() * static_cast<double>(sheet_.leaves.size());
            organ.shape = static_cast<OrganShapeId>(*first[organ.shape] + static_cast<int>(number));
        }
        return std::move(plant_);
    }

private:
    bool has_room() const
    {
        return plant_.organ_shapes.size() + sheet_.leaves.size()
            <= std::numeric_limits<OrganShapeId>::max();
    }

    // Appends a shape for each leaf of the sheet, in place of `of`. Returns the id of the first.
    OrganShapeId add_leaves(OrganShape const& of)
    {
        auto organ = of; // A copy, since the list that contains `of` may be reallocated.
        organ.material = material_of(of.material);
        auto const first = static_cast<OrganShapeId>(plant_.organ_shapes.size());
        for (auto const& leaf : sheet_.leaves)
            plant_.organ_shapes.push_back(lsystem::leaf_shape(organ, leaf));
        return first;
    }

    MaterialId material_of(MaterialId own)
    {
        auto const [known, is_new] = materials_.try_emplace(own, MaterialId { 0 });
        if (is_new) {
            auto material = plant_.materials[own];
            material.base_color = sheet_.mean_color;
            material.textures = lsystem::leaf_textures(sheet_);
            plant_.materials.push_back(std::move(material));
            known->second = static_cast<MaterialId>(plant_.materials.size() - 1);
        }
        return known->second;
    }

    lsystem::LeafSheet const& sheet_;
    Plant plant_;
    std::map<MaterialId, MaterialId> materials_;
};

} // namespace

bool is_leaf(Plant const& plant, OrganShape const& shape)
{
    return plant.materials[shape.material].kind == Material::Kind::Leaf
        && shape.kind != OrganShape::Kind::Needle && shape.kind != OrganShape::Kind::Ball
        && shape.kind != OrganShape::Kind::Disc;
}

Plant foliated(Plant const& plant, lsystem::LeafSheet const& sheet)
{
    return sheet.leaves.empty() ? plant : FoliageSetter(plant, sheet).run();
}

} // namespace tractus::scene
