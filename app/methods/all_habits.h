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

// English names of the built-in tree habits (growth presets of species), in alphabetical order.
std::vector<std::string> habit_names();

// Returns the edit that adds a tree grown without strokes for `years` years. `habit` is the English
// or Latin name of a built-in habit, or the path of a .habit file. Fails with a user error if there
// is no such habit.
Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed);

// Trees of one habit that grow in rows and shade each other.
struct StandOfTrees {
    std::string habit {};   // Name or file of the habit, as for tree_of_habit().
    int years = 1;          // Age of the trees.
    std::uint64_t seed = 1; // Seed of the first tree; the others count on from it.
    int count = 4;          // Number of trees, in a square grid whose last rows may be incomplete.
    double spacing_m = 4;   // Distance between rows, and between the trees of a row.
};

// Returns the edits that plant the trees around the world's origin and let them grow. Fails like
// tree_of_habit().
Result<std::vector<scene::Edit>> edits_for_stand(StandOfTrees const& stand);

// How a plant continues to grow as a self-organising tree.
struct GrowthFrom {
    std::string habit {}; // Name or file of the habit, as for tree_of_habit().
    int years = 1;
    std::uint64_t seed = 1;
    bool fills = false; // The tree fills the crown of a plant that was drawn by its outline.
};

// Returns the edit that lets the active plant of a scene continue to grow. Fails with a user error
// if there is no such habit or no plant, or if `growth` fills a crown and the plant has none.
Result<scene::Edit> growth_from(scene::Scene const& scene, GrowthFrom const& growth);

// The tree in each year of its growth, if the scene is one self-organising tree without bent,
// grafted or hidden parts; no value for any other scene. Fails if the tree cannot be grown.
Result<std::optional<self_organising::TreeFilm>> years_of_tree(scene::Scene const& scene,
                                                               scene::LoadOptions const& options);

} // namespace tractus::methods
