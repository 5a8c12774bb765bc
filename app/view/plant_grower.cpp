#include "app/view/plant_grower.h"

#include "engine/mesh/join_meshes.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/growth.h"

#include <map>

namespace tractus::view {

namespace {

// Grows a plant's mesh. The result is unusable once `stop` has been requested.
Result<mesh::Mesh> grow_mesh(scene::BuiltPlant const& built, scene::SetGrowth const& growth,
                             scene::SceneShaper& shaper, mesh::MeshOptions const& options,
                             std::stop_token const& stop)
{
    auto wanted = built;
    wanted.growth = growth;
    auto const plan = TRY(scene::plan_growth(wanted, shaper, stop));
    if (stop.stop_requested())
        return mesh::Mesh {};
    variation::Grower grower(plan);
    auto const& plant = grower.grow({ growth.seed, 0 }, growth.age, stop);
    if (stop.stop_requested())
        return mesh::Mesh {};
    return mesh::make_mesh(plant, options, stop);
}

// Grows the plants of successive scenes; unchanged plants are reused.
class SceneGrower {
public:
    Result<mesh::Mesh> grow(WantedPlant const& wanted, std::stop_token const& stop)
    {
        auto const& scene = *wanted.scene;
        bool const is_hidden = scene.drawn->is_hidden && !scene.plants.empty();
        auto mesh = is_hidden ? Result<mesh::Mesh>(mesh::Mesh {})
                              : grow_mesh(scene, wanted.growth, active_, {}, stop);
        if (!mesh)
            return mesh;
        std::map<scene::ItemId, Other> still_there;
        for (auto const& plant : scene.plants) {
            if (plant->drawn == scene.drawn || plant->drawn->is_hidden)
                continue;
            auto& other = still_there[plant->drawn->id] = std::move(others_[plant->drawn->id]);
            if (other.plant != plant)
                other = { plant, TRY(grow_mesh(*plant, plant->growth, other_, {}, stop)) };
            if (stop.stop_requested())
                break;
            Vec3 const moved_mm
                = scene.placement.plant_of_world(plant->placement.world_of_plant(Vec3::Zero()));
            mesh::append_mesh(*mesh, other.mesh, moved_mm.cast<float>());
        }
        // After an aborted run the list is incomplete and must not be reused.
        if (!stop.stop_requested())
            others_ = std::move(still_there);
        else
            others_.clear();
        return mesh;
    }

private:
    struct Other {
        // The plant whose mesh this is; shared with the scenes that contain it.
        std::shared_ptr<scene::BuiltPlant const> plant;
        mesh::Mesh mesh;
    };

    scene::SceneShaper active_;
    scene::SceneShaper other_;
    std::map<scene::ItemId, Other> others_;
};

} // namespace

// Mesh options good enough for an image a few hundred pixels wide.
static mesh::MeshOptions coarse()
{
    return { .min_sides = 3,
             .max_sides = 6,
             .subdivision = 1,
             .collar = 0,
             .ends = mesh::MeshOptions::Ends::Open,
             .sections = mesh::MeshOptions::Sections::SameArea,
             .organs = mesh::MeshOptions::Organs::Cards };
}

PlantGrower::PlantGrower()
    // Shared, as the function object is copied; only one copy is called.
    : plant_([grower = std::make_shared<SceneGrower>()](
                 WantedPlant const& wanted,
                 std::stop_token const& stop) { return grower->grow(wanted, stop); },
             Urgency::Later)
    , variation_(make_variation, Urgency::Later)
    , worn_out_([](std::unique_ptr<mesh::Mesh const> const&) { return true; }, Urgency::Later)
{
}

PlantGrower::MadeVariation PlantGrower::make_variation(WantedVariation const& wanted,
                                                       std::stop_token const& stop)
{
    scene::SceneShaper shaper;
    auto mesh = grow_mesh(*wanted.plant.scene, wanted.plant.growth, shaper, coarse(), stop);
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

} // namespace tractus::view
