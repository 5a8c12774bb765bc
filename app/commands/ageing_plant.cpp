#include "app/commands/ageing_plant.h"

#include "app/methods/all_habits.h"
#include "engine/variation/ground.h"
#include "engine/variation/growth.h"

#include <optional>
#include <utility>

namespace tractus::commands {

namespace {

// A plant that varied_plant() returns: its growth is simulated by variation::Grower.
class VariedPlant final : public AgeingPlant {
public:
    VariedPlant(variation::GrowthPlan plan, scene::Scene const& scene, bool along_ground)
        : plan_(std::move(plan))
        , grower_(plan_)
        , key_ { scene.growth.seed, 0 }
        , along_ground_(along_ground)
    {
    }

    Plant const& grow(double age) override
    {
        auto const& grown = grower_.grow(key_, age);
        if (!along_ground_)
            return grown;
        bent_ = grown;
        variation::bend_along_ground(bent_, plan_.base);
        return bent_;
    }

    Plant parts(double age) override { return variation::without_unborn(grow(age)); }

private:
    variation::GrowthPlan plan_;
    variation::Grower grower_;
    variation::PlantKey key_;
    bool along_ground_;
    Plant bent_;
};

// A self-organising tree, whose ages are the years that it has lived.
class YearlyPlant final : public AgeingPlant {
public:
    explicit YearlyPlant(self_organising::TreeFilm film)
        : film_(std::move(film))
        , plant_(film_.whole())
    {
    }

    Plant const& grow(double age) override
    {
        film_.shape_at(age * film_.years(), plant_);
        return plant_;
    }

    // Unlike grow(), includes branches that die at a later age.
    Plant parts(double age) override { return film_.plant_at(age * film_.years()); }

private:
    self_organising::TreeFilm film_;
    Plant plant_;
};

} // namespace

Result<std::unique_ptr<AgeingPlant>> varied_plant(scene::Scene const& scene, bool along_ground)
{
    return std::make_unique<VariedPlant>(TRY(scene::plan_growth(scene)), scene, along_ground);
}

Result<std::unique_ptr<AgeingPlant>> plant_of_ages(scene::Scene const& scene,
                                                   scene::MakeLoadOptions const& options)
{
    if (auto film = TRY(methods::years_of_tree(scene, options ? options() : scene::LoadOptions {})))
        return std::make_unique<YearlyPlant>(*std::move(film));
    return varied_plant(scene, false);
}

} // namespace tractus::commands
