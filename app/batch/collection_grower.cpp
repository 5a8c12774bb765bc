#include "app/batch/collection_grower.h"

#include "engine/variation/ground.h"

#include <utility>

namespace tractus::batch {

Result<std::unique_ptr<CollectionGrower::Planned>> CollectionGrower::planned(scene::Scene scene)
{
    auto result = std::make_unique<Planned>(std::move(scene));
    result->plan
        = std::make_unique<variation::GrowthPlan const>(TRY(scene::plan_growth(result->scene)));
    result->kept
        = variation::axes_below_paths(result->plan->base, scene::drawn_paths(result->scene));
    result->grower = std::make_unique<variation::Grower>(*result->plan);
    return result;
}

Result<CollectionGrower> CollectionGrower::create(scene::Scene scene, double construction)
{
    CollectionGrower grower;
    grower.construction_ = scene::has_sources_that_vary(scene) ? construction : 0;
    grower.shared_ = TRY(planned(std::move(scene)));
    return grower;
}

Result<Plant> CollectionGrower::drawn() const
{
    auto as_drawn = shared_->scene;
    as_drawn.growth.variability = 0;
    auto const plan = TRY(scene::plan_growth(as_drawn));
    return variation::Grower(plan).grow({});
}

Plant const& CollectionGrower::grown(Planned& planned, variation::PlantKey const& key, double age)
{
    auto const* plant = &planned.grower->grow(key, age);
    if (is_above_ground_) {
        bent_ = *plant;
        variation::bend_along_ground(bent_, planned.plan->base);
        plant = &bent_;
    }
    underground_ = variation::segments_underground(*plant, planned.plan->base).size();
    return *plant;
}

bool CollectionGrower::is_varied(variation::PlantKey const& key) const
{
    return construction_ > 0 || own_seeds_.has(key);
}

Result<std::unique_ptr<CollectionGrower::Planned>>
CollectionGrower::planned_for(variation::PlantKey const& key) const
{
    auto scene = own_seeds_.scene_of(shared_->scene, key);
    if (construction_ > 0)
        scene = TRY(scene::varied(
            scene, { .seed = key.seed, .plant = key.plant_index, .spread = construction_ }));
    return planned(std::move(scene));
}

// Returns the scene and growth plan for a key. They are kept until another key is requested, as a
// plant may be needed at several ages or levels of detail.
CollectionGrower::Planned& CollectionGrower::planned_of(variation::PlantKey const& key)
{
    if (!is_varied(key))
        return *shared_;
    bool const is_same = key_ && key_->seed == key.seed && key_->plant_index == key.plant_index;
    if (!is_same) {
        key_ = key;
        auto made = planned_for(key);
        failed_count_ += !made;
        varied_ = made ? *std::move(made) : nullptr;
    }
    return varied_ ? *varied_ : *shared_;
}

Plant const& CollectionGrower::grow(variation::PlantKey const& key, double age)
{
    auto& planned = planned_of(key);
    auto const& plant = grown(planned, key, age);
    if (individuality_ == variation::Individuality {})
        return plant;
    individual_ = variation::individual(plant, key, individuality_, planned.kept);
    return individual_;
}

Plant CollectionGrower::comparable(variation::PlantKey const& key, double age)
{
    auto& planned = planned_of(key);
    return variation::comparable_individual(grown(planned, key, age), key, individuality_,
                                            planned.kept);
}

} // namespace tractus::batch
