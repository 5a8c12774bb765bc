#pragma once

#include "app/batch/drawing.h"
#include "app/document/model_cost.h"
#include "app/io/model_file.h"
#include "app/tools/methods.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::batch {

// A self-organising tree. The tree grows from a seed or, if there is a model, from the model's
// plant.
struct TreeToGrow {
    std::string habit {}; // Name or file of the habit; empty: no self-organising tree.
    int years = 20;       // Number of years that the tree grows.
    int stand = 1;        // Number of trees that grow beside each other.
    double spacing_m = 4; // Distance between neighbouring trees.
    bool fills = false;   // True: the tree fills the outlined crown of the model's plant.
};

// What to grow, as the command "grow" and other programs ask for it.
struct PlantToGrow {
    // Name or path (find_model()) of a model, a skeleton, a measured plant or a session. Empty: a
    // tree of a habit by itself.
    std::string model {};
    std::optional<int> steps {}; // Number of derivation steps. Default: as given in the model.
    // Seed of the model's stochastic rules, of the tree and of growth. Default: the session's seed,
    // or 1.
    std::optional<std::uint64_t> seed {};
    io::ModelCompanions companions {};
    document::ModelCost cost {};
    TreeToGrow tree {};
    GrowthOptions growth {};

    // True if growth varies the plant. Otherwise the plant is as its model gives it.
    bool is_varied() const
    {
        return growth.preset || growth.variability != 1 || growth.along_ground;
    }
};

// A plant as loaded, before it is varied.
struct LoadedPlant {
    scene::Scene scene;
    std::string name;
    bool is_session = false;
    std::vector<std::string> warnings {}; // Of the model and the files beside it.
};

// Loads the plant without its growth options, with_growth(). Fails with a user error if there is no
// such model or habit, if the model fails, or if the options contradict each other.
Result<LoadedPlant> load_plant_to_grow(PlantToGrow const& what, tools::Methods const& methods);

// Loads a model that has been read already, with the steps and seed of its edit, to be shown
// without variation. Fails like build_lsystem().
Result<scene::Scene> scene_of_model(scene::LoadModel const& model, document::ModelCost const& cost);

// Applies growth options to a scene. Without a preset, growth keeps the session's parameters, and
// the given variability multiplies the session's.
Result<scene::Scene> with_growth(GrowthOptions const& options, scene::Scene scene);

} // namespace tractus::batch
