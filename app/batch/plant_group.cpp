#include "app/batch/plant_group.h"

#include "engine/plant/join_plants.h"
#include "engine/variation/growth.h"

#include <utility>

namespace tractus::batch {

// The plants that are shown. The scene may have the active plant otherwise than the document has
// it, and may be of one plant that no document has.
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
        group.members_.push_back(
            std::make_unique<Member>(Member { std::move(plan), std::move(grower), plant->growth,
                                              shown.front()->placement.plant_of_world(base_mm) }));
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

Plant PlantGroup::as_set() const
{
    Plant all;
    for (auto const& member : members_) {
        auto const& [parameters, seed, variability, age] = member->growth;
        Plant young;
        auto const& plant = at_age(member->grower.grow({ seed, 0 }, age), age, young);
        if (member == members_.front())
            all = plant;
        else
            append_plant(all, plant, member->moved_mm);
    }
    return all;
}

Plant const& PlantGroup::grow(variation::PlantKey const& key, double age)
{
    Plant young;
    auto const& first = members_.front()->grower.grow(key, age);
    if (members_.size() == 1 && age >= 1)
        return first;
    whole_ = at_age(first, age, young);
    for (std::size_t i = 1; i < members_.size(); ++i) {
        auto& [plan, grower, growth, moved_mm] = *members_[i];
        append_plant(whole_, at_age(grower.grow(key, age), age, young), moved_mm);
    }
    return whole_;
}

Result<Plant> shown_plants(scene::Scene const& scene)
{
    auto const group = TRY(PlantGroup::create(scene));
    return group.as_set();
}

} // namespace tractus::batch
