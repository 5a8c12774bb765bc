#include "app/batch/plant_group.h"

#include "engine/plant/join_plants.h"
#include "engine/variation/ground.h"
#include "engine/variation/growth.h"

#include <utility>

namespace tractus::batch {

// Returns the visible plants of a scene. The scene itself stands for the active plant, which may be
// modified; a scene outside a document is a single plant.
static std::vector<scene::BuiltPlant const*> shown_in(scene::Scene const& scene)
{
    if (scene.plants.empty())
        return { &scene };
    std::vector<scene::BuiltPlant const*> shown;
    for (auto const& plant : scene.plants) {
        bool const is_active = plant->drawn->id == scene.drawn->id;
        if (!plant->drawn->is_hidden)
            shown.push_back(is_active ? &scene : plant.get());
    }
    return shown;
}

Result<PlantGroup> PlantGroup::create(scene::Scene const& scene)
{
    auto const shown = shown_in(scene);
    if (shown.empty())
        return fail(Fault::User, "all plants are hidden: show one");
    PlantGroup group;
    for (auto const* plant : shown) {
        auto plan = std::make_unique<variation::GrowthPlan const>(TRY(scene::plan_growth(*plant)));
        variation::Grower grower(*plan);
        auto const base_mm = plant->placement.world_of_plant(Vec3::Zero());
        auto kept = variation::axes_below_paths(plan->base, scene::drawn_paths(*plant));
        group.members_.push_back(std::make_unique<Member>(
            Member { std::move(plan), std::move(grower), plant->growth,
                     shown.front()->placement.plant_of_world(base_mm), std::move(kept) }));
    }
    return group;
}

static Plant const& at_age(Plant const& grown, double age, Plant& young)
{
    if (age >= 1)
        return grown;
    young = variation::without_unborn(grown);
    return young;
}

// Returns the whole plant of a member. `bent` provides storage for the result.
Plant const& PlantGroup::grown(Member& member, variation::PlantKey const& key, double age,
                               Plant& bent)
{
    auto const* plant = &member.grower.grow(key, age);
    if (is_above_ground_) {
        bent = *plant;
        variation::bend_along_ground(bent, member.plan->base);
        plant = &bent;
    }
    underground_ += variation::segments_underground(*plant, member.plan->base).size();
    return *plant;
}

// Returns the plant of a member for a collection. `plant` provides storage for the result. All
// members share the key of growth; for individual differences each member has a key of its own.
Plant const& PlantGroup::of_collection(std::size_t number, variation::PlantKey key, double age,
                                       Plant& plant)
{
    auto& member = *members_[number];
    auto const& whole = grown(member, key, age, plant);
    if (individuality_ == variation::Individuality {})
        return whole;
    key.seed ^= static_cast<std::uint64_t>(number) << 48;
    plant = variation::individual(whole, key, individuality_, member.kept);
    return plant;
}

Plant PlantGroup::plant_as_displayed()
{
    underground_ = 0;
    Plant all;
    Plant bent;
    for (auto const& member : members_) {
        auto const& [parameters, seed, variability, age] = member->growth;
        Plant young;
        auto const& plant = at_age(grown(*member, { seed, 0 }, age, bent), age, young);
        if (member == members_.front())
            all = plant;
        else
            append_plant(all, plant, member->moved_mm);
    }
    return all;
}

Plant const& PlantGroup::grow(variation::PlantKey const& key, double age)
{
    underground_ = 0;
    if (members_.size() == 1 && age >= 1)
        return of_collection(0, key, age, whole_);
    Plant young;
    Plant bent;
    whole_ = at_age(of_collection(0, key, age, bent), age, young);
    for (std::size_t i = 1; i < members_.size(); ++i)
        append_plant(whole_, at_age(of_collection(i, key, age, bent), age, young),
                     members_[i]->moved_mm);
    return whole_;
}

Result<Plant> shown_plants(scene::Scene const& scene, bool along_ground)
{
    auto group = TRY(PlantGroup::create(scene));
    if (along_ground)
        group.keep_above_ground();
    return group.plant_as_displayed();
}

} // namespace tractus::batch
