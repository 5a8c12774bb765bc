#include "app/view/plant_grower.h"

#include "app/tools/underground.h"
#include "engine/export/texture.h"
#include "engine/mesh/join_meshes.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene_shaper.h"
#include "engine/scene/varied_scene.h"
#include "engine/variation/ground.h"
#include "engine/variation/growth.h"

#include <algorithm>
#include <map>

namespace tractus::view {

namespace {

// A plant with its growth plan. Not movable, as the grower refers to the plan.
struct Growing {
    explicit Growing(variation::GrowthPlan made)
        : plan(std::move(made))
    {
    }

    variation::GrowthPlan plan;
    variation::Grower grower { plan };
    Plant bent {}; // Last result of grow() with `along_ground`.

    // Grows the plant. The result is unusable once `stop` has been requested.
    Plant const& grow(std::uint64_t seed, double age, bool along_ground,
                      std::stop_token const& stop)
    {
        auto const& grown = grower.grow({ seed, 0 }, age, stop);
        if (!along_ground || stop.stop_requested())
            return grown;
        bent = grown;
        variation::bend_along_ground(bent, plan.base);
        return bent;
    }
};

// Plans the growth of a plant. The result is null once `stop` has been requested.
Result<std::unique_ptr<Growing>> growing(scene::BuiltPlant const& built,
                                         scene::SetGrowth const& growth, scene::SceneShaper& shaper,
                                         std::stop_token const& stop)
{
    auto wanted = built;
    wanted.growth = growth;
    auto plan = TRY(scene::plan_growth(wanted, shaper, stop));
    if (stop.stop_requested())
        return nullptr;
    return std::make_unique<Growing>(std::move(plan));
}

GrownUnderground underground_of(Plant const& plant, Plant const& base,
                                scene::BuiltPlant const& built)
{
    GrownUnderground result { .segments = plant.segment_count() };
    auto const below = variation::segments_underground(plant, base);
    if (below.empty())
        return result;
    auto const by_strokes = tools::segments_bent_underground(built);
    for (auto const segment : below) {
        auto const nodes = nodes_of(plant, segment);
        result.lines.push_back({ plant.node_position_mm[nodes.base].cast<float>(),
                                 plant.node_position_mm[nodes.tip].cast<float>(),
                                 !std::ranges::binary_search(by_strokes, segment) });
    }
    return result;
}

} // namespace

// Makes the pictures of a mesh's bark on the growing thread: the window's thread would stand still.
static mesh::Mesh with_bark(mesh::Mesh mesh)
{
    exports::prepare_bark(mesh);
    return mesh;
}

// Grows the plants of successive scenes. Plants that have not changed are not grown again.
class PlantGrower::SceneGrower {
public:
    Result<GrownPlants> grow(PlantRequest const& wanted, std::stop_token const& stop)
    {
        auto const& scene = *wanted.scene;
        GrownPlants grown;
        if (!scene.drawn->is_hidden || scene.plants.empty())
            grown = TRY(grow_one(scene, wanted, wanted.growth, active_, stop));
        std::map<scene::ItemId, Other> still_there;
        for (auto const& plant : scene.plants) {
            if (plant->drawn == scene.drawn || plant->drawn->is_hidden)
                continue;
            auto& other = still_there[plant->drawn->id] = std::move(others_[plant->drawn->id]);
            if (other.plant != plant || other.along_ground != wanted.along_ground)
                other = { plant, wanted.along_ground,
                          TRY(grow_one(*plant, wanted, plant->growth, other_, stop)).mesh };
            if (stop.stop_requested())
                break;
            Vec3 const moved_mm
                = scene.placement.plant_of_world(plant->placement.world_of_plant(Vec3::Zero()));
            mesh::append_mesh(grown.mesh, other.mesh, moved_mm.cast<float>());
        }
        // If the run was stopped, `still_there` is incomplete and must not be reused.
        if (!stop.stop_requested())
            others_ = std::move(still_there);
        else
            others_.clear();
        return grown;
    }

private:
    struct Other {
        // The plant from which `mesh` was made. Shared with the scenes that contain it.
        std::shared_ptr<scene::BuiltPlant const> plant;
        bool along_ground = false; // True if `mesh` was grown along the ground (see PlantRequest).
        mesh::Mesh mesh;
    };

    static Result<GrownPlants> grow_one(scene::BuiltPlant const& built, PlantRequest const& wanted,
                                        scene::SetGrowth const& growth, scene::SceneShaper& shaper,
                                        std::stop_token const& stop)
    {
        auto const made = TRY(growing(built, growth, shaper, stop));
        if (!made)
            return GrownPlants {};
        auto const& plant = made->grow(growth.seed, growth.age, wanted.along_ground, stop);
        if (stop.stop_requested())
            return GrownPlants {};
        return GrownPlants { with_bark(mesh::make_mesh(plant, {}, stop)),
                             underground_of(plant, made->plan.base, built) };
    }

    scene::SceneShaper active_;
    scene::SceneShaper other_;
    std::map<scene::ItemId, Other> others_;
};

// Coarse mesh options for a picture that is a few hundred pixels wide.
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

// Grows the variations that are requested one after another.
class PlantGrower::VariationMaker {
public:
    VariationResult make(VariationRequest const& wanted, std::stop_token const& stop)
    {
        auto mesh = grow(wanted, stop);
        if (!mesh)
            return { tl::unexpected(std::move(mesh).error()), wanted.wish };
        return { Variation { wanted.plant.growth.seed, *std::move(mesh) }, wanted.wish };
    }

private:
    Result<mesh::Mesh> grow(VariationRequest const& wanted, std::stop_token const& stop)
    {
        auto const& how = wanted.individuality;
        auto const& growth = wanted.plant.growth;
        variation::PlantKey const key { growth.seed, 0 };
        if (of_ != wanted.plant.scene || share_ != how.seeds) {
            alone_ = scene::active_plant_alone(*wanted.plant.scene);
            own_seeds_ = { alone_, how.seeds };
            of_ = wanted.plant.scene;
            share_ = how.seeds;
        }
        scene::SceneShaper shaper;
        auto const scene = own_seeds_.scene_of(alone_, key);
        auto const made = TRY(growing(scene, growth, shaper, stop));
        if (!made)
            return mesh::Mesh {};
        auto const age = variation::individual_age(key, how, growth.age);
        auto const& plant = made->grow(growth.seed, age, wanted.plant.along_ground, stop);
        if (stop.stop_requested())
            return mesh::Mesh {};
        if (how == variation::Individuality {})
            return with_bark(mesh::make_mesh(plant, coarse(), stop));
        auto const kept = variation::axes_below_paths(made->plan.base, scene::drawn_paths(scene));
        return with_bark(
            mesh::make_mesh(variation::individual(plant, key, how, kept), coarse(), stop));
    }

    // Scene and Individuality::seeds of the last request, from which alone_ and own_seeds_ are
    // computed. The scene is immutable and shared.
    std::shared_ptr<scene::Scene const> of_;
    double share_ = 0;
    scene::Scene alone_;
    scene::SeedAssignment own_seeds_;
};

PlantGrower::PlantGrower()
    // Held by shared_ptr, as std::function requires a function object that can be copied.
    : plant_([grower = std::make_shared<SceneGrower>()](
                 PlantRequest const& wanted,
                 std::stop_token const& stop) { return grower->grow(wanted, stop); },
             Urgency::Later)
    , variation_([maker = std::make_shared<VariationMaker>()](
                     VariationRequest const& wanted,
                     std::stop_token const& stop) { return maker->make(wanted, stop); },
                 Urgency::Later)
    , worn_out_([](std::unique_ptr<mesh::Mesh const> const&) { return true; }, Urgency::Later)
{
}

std::optional<Result<mesh::Mesh>> PlantGrower::take()
{
    auto grown = plant_.take();
    if (!grown)
        return std::nullopt;
    if (!*grown)
        return Result<mesh::Mesh>(tl::unexpected(std::move(*grown).error()));
    underground_ = std::move((*grown)->underground);
    return Result<mesh::Mesh>(std::move((*grown)->mesh));
}

void PlantGrower::vary(VariationsRequest wanted)
{
    variations_ = std::move(wanted);
    varied_ = std::vector<Variation> {};
    ++wish_;
    request_next();
}

void PlantGrower::request_next()
{
    if (variations_.count > 0)
        variation_.want({ variations_.like, variations_.individuality, wish_ });
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
        request_next();
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
