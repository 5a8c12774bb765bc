#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/tree_film.h"
#include "engine/scene/edit_kind.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tractus::methods {

// English names of the built-in tree habits (growth parameters of species), in alphabetical order.
std::vector<std::string> habit_names();

// Returns the edit that adds a tree grown without strokes for `years` years. `habit` is the English
// or Latin name of a built-in habit, or the path of a .habit file. Fails with a user error if there
// is no such habit.
Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed);

// Trees of one habit that grow in rows and shade each other.
struct StandOfTrees {
    std::string habit {}; // Name or file of the habit (tree_of_habit()).
    int years = 1;        // Age of all trees.
    // Seed of the first tree; each further tree has the next number as its seed.
    std::uint64_t seed = 1;
    // Number of trees. They stand in a square grid, whose last row may be incomplete.
    int count = 4;
    double spacing_m = 4; // Distance between rows, and between neighbouring trees of a row.
};

// Returns the edits that plant the trees around the world's origin and let them grow. Fails with a
// user error if there is no such habit.
Result<std::vector<scene::Edit>> edits_for_stand(StandOfTrees const& stand);

// How a plant is to continue growing as a self-organising tree.
struct GrowthFrom {
    std::string habit {}; // Name or file of the habit (tree_of_habit()).
    int years = 1;
    std::uint64_t seed = 1;
    bool fills = false; // The tree fills the crown of a plant that was drawn by its outline.
};

// Returns the edit that lets the active plant of a scene continue growing. Fails with a user error
// if there is no such habit or no plant, or if a crown is to be filled (GrowthFrom::fills) and the
// plant has none.
Result<scene::Edit> growth_from(scene::Scene const& scene, GrowthFrom const& growth);

// The tree in each year of its growth, if the scene's only plant is a self-organising tree without
// bent, grafted or hidden parts. No value for any other scene. Fails if the tree cannot be grown.
Result<std::optional<self_organising::TreeFilm>> years_of_tree(scene::Scene const& scene,
                                                               scene::LoadOptions const& options);

} // namespace tractus::methods
