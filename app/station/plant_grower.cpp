#include "app/station/plant_grower.h"

#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/growth.h"

namespace tractus {

// What it gives after `stop` has asked it to end is dropped.
static Result<Mesh> grow_mesh(WantedPlant const& wanted, SceneShaper& shaper,
                              MeshOptions const& options, std::stop_token const& stop)
{
    auto const scene = TRY(apply_edit(*wanted.scene, wanted.growth));
    auto const plan = TRY(plan_growth(scene, shaper, stop));
    if (stop.stop_requested())
        return Mesh {};
    Grower grower(plan);
    auto const& plant = grower.grow({ wanted.growth.seed, 0 }, wanted.growth.age, stop);
    if (stop.stop_requested())
        return Mesh {};
    return make_mesh(plant, options, stop);
}

// What a picture of a few hundred pixels shows.
static MeshOptions coarse()
{
    return { .min_sides = 3,
             .max_sides = 6,
             .subdivision = 1,
             .collar = 0,
             .ends = MeshOptions::Ends::Open,
             .sections = MeshOptions::Sections::SameArea,
             .organs = MeshOptions::Organs::Cards };
}

PlantGrower::PlantGrower()
    // Shared by the copies of the function, of which one is called.
    : plant_([shaper = std::make_shared<SceneShaper>()](
                 WantedPlant const& wanted,
                 std::stop_token const& stop) { return grow_mesh(wanted, *shaper, {}, stop); },
             Urgency::Later)
    , variation_(make_variation, Urgency::Later)
    , worn_out_([](std::unique_ptr<Mesh const> const&) { return true; }, Urgency::Later)
{
}

PlantGrower::MadeVariation PlantGrower::make_variation(WantedVariation const& wanted,
                                                       std::stop_token const& stop)
{
    SceneShaper shaper;
    auto mesh = grow_mesh(wanted.plant, shaper, coarse(), stop);
    if (!mesh)
        return { tl::unexpected(std::move(mesh).error()), wanted.wish };
    return { Variation { wanted.plant.growth.seed, *std::move(mesh) }, wanted.wish };
}

void PlantGrower::vary(WantedVariations wanted)
{
    variations_ = std::move(wanted);
    varied_ = std::vector<Variation> {};
    ++wish_;
    want_next();
}

void PlantGrower::want_next()
{
    if (variations_.count > 0)
        variation_.want({ variations_.like, wish_ });
}

void PlantGrower::take_variation()
{
    auto made = variation_.take();
    if (!made || made->wish != wish_)
        return;
    if (made->variation) {
        varied_->push_back(*std::move(made->variation));
        --variations_.count;
        ++variations_.like.growth.seed;
        want_next();
    } else {
        varied_ = tl::unexpected(std::move(made->variation).error());
        variations_.count = 0;
    }
}

Result<std::vector<Variation>> PlantGrower::take_variations()
{
    take_variation();
    return std::exchange(varied_, std::vector<Variation> {});
}

void PlantGrower::settle()
{
    plant_.settle();
    while (variations_.count > 0) {
        variation_.settle();
        take_variation();
    }
    worn_out_.settle();
}

} // namespace tractus
