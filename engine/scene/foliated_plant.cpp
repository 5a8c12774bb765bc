#include "engine/scene/foliated_plant.h"

#include "engine/base/random.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::scene {

namespace {

constexpr std::uint32_t kLeafStream = 0x1eaf;

// Mean length of the leaves of a spray; 1 if the shape is none.
double mean_leaf_length_mm(OrganShape const& shape)
{
    double sum_mm = 0;
    for (auto const& leaf : shape.spray)
        sum_mm += leaf.length_mm;
    return shape.spray.empty() ? 1 : sum_mm / static_cast<double>(shape.spray.size());
}

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
        first_.resize(own);
        for (std::size_t i = 0; i < own; ++i)
            if (is_leaf(plant_, plant_.organ_shapes[i]) && has_room())
                first_[i] = add_leaves(plant_.organ_shapes[i]);
        auto const organs = std::exchange(plant_.organs, {});
        plant_.organs.reserve(organs.size());
        for (std::size_t i = 0; i < organs.size(); ++i)
            replace(organs[i], { 0, kLeafStream, static_cast<std::uint32_t>(i) });
        return std::move(plant_);
    }

private:
    // Appends a leaf of the sheet for an organ, or one for each leaf of a spray. Organs that are
    // not leaves stay as they are.
    void replace(Organ const& organ, RandomKey const& key)
    {
        auto const& first = first_[organ.shape];
        if (!first) {
            plant_.organs.push_back(organ);
            return;
        }
        Random random(key);
        auto const add = [&](Organ leaf) {
            auto const number = random.uniform() * static_cast<double>(sheet_.leaves.size());
            leaf.shape = static_cast<OrganShapeId>(*first + static_cast<int>(number));
            plant_.organs.push_back(leaf);
        };
        auto const& shape = plant_.organ_shapes[organ.shape];
        if (shape.spray.empty())
            add(organ);
        double const mean_mm = mean_leaf_length_mm(shape);
        for (auto const& leaf : shape.spray) {
            auto one = organ;
            Vec3 const base = organ.scale.cast<double>().cwiseProduct(leaf.base_mm);
            one.position_mm += organ.orientation * base;
            one.orientation = organ.orientation * leaf.orientation;
            one.scale *= static_cast<float>(leaf.length_mm / mean_mm);
            add(one);
        }
    }

    bool has_room() const
    {
        return plant_.organ_shapes.size() + sheet_.leaves.size()
            <= std::numeric_limits<OrganShapeId>::max();
    }

    // Appends a shape for each leaf of the sheet, in place of `of` or of one leaf of that spray.
    // Returns the id of the first.
    OrganShapeId add_leaves(OrganShape const& of)
    {
        auto organ = of; // A copy, since the list that contains `of` may be reallocated.
        double const own_mm = !of.spray.empty() ? mean_leaf_length_mm(of)
            : of.cut                            ? of.length_mm
                                                : of.length_mm - of.petiole_mm;
        organ.length_mm = own_mm / mean_tip();
        organ.petiole_mm = 0;
        organ.cut = nullptr;
        organ.spray.clear();
        organ.material = material_of(of.material);
        auto const first = static_cast<OrganShapeId>(plant_.organ_shapes.size());
        for (auto const& leaf : sheet_.leaves)
            plant_.organ_shapes.push_back(lsystem::leaf_shape(organ, leaf));
        return first;
    }

    // Mean distance of the tips of the sheet's leaves from their bases, in their unit.
    double mean_tip() const
    {
        double sum = 0;
        for (auto const& leaf : sheet_.leaves)
            sum += box_of(*leaf).max().y();
        return std::max(sum / static_cast<double>(sheet_.leaves.size()), 1e-6);
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
    // For each of the plant's own shapes, the shape of the first new leaf; no value: it stays.
    std::vector<std::optional<OrganShapeId>> first_;
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
