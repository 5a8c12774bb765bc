#include "app/plant_grower.h"

#include "engine/mesh/make_mesh.h"
#include "engine/variation/growth.h"

namespace tractus {

static Result<Mesh> grow_mesh(WantedPlant const& wanted, MeshOptions const& options)
{
    auto const scene = TRY(apply_edit(*wanted.scene, wanted.growth));
    auto const plan = TRY(plan_growth(scene));
    Grower grower(plan);
    return make_mesh(grower.grow({ wanted.growth.seed, 0 }, wanted.growth.age), options);
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
    : plant_([](WantedPlant const& wanted) { return grow_mesh(wanted, {}); })
    , variation_(make_variation)
{
}

PlantGrower::MadeVariation PlantGrower::make_variation(WantedVariation const& wanted)
{
    auto mesh = grow_mesh(wanted.plant, coarse());
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
}

} // namespace tractus
