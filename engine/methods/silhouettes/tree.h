#pragma once

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/spray.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::silhouette {

// How the branches of one level stand around their parents.
struct LevelOptions {
    Pattern pattern = Pattern::Even;
    double added = 1.5; // Branches that nobody sees in the plane, for each one in it; 0 or more.
    int proposals = 3000;
    ArrangementOptions::Nodes nodes = ArrangementOptions::Nodes::Whole;
    // If it is set, it says how many branches there are and where, and at which angles those are
    // added: the ones that were inferred move to the nearest of its places, those that were drawn
    // stay, and `added` says nothing.
    BranchStyle style {};
};

struct TreeOptions {
    std::vector<LevelOptions> levels { {},
                                       { .added = 0.5, .proposals = 600 } }; // The last goes on.
    BranchingAngles angles {}; // Of branches that are added.
    double height_mm = 8000;   // Of the drawing.
    std::uint64_t seed = 1;
    std::size_t sprays = 12; // On a branch of the last level of 7 % of the height.
    LeafForm leaf {};
    Vec3f leaf_color { 0.25f, 0.42f, 0.13f };
    Vec3f bark_color { 0.34f, 0.27f, 0.2f };
    double tip_radius_of_height = 0.0006;
};

// A branch around its parent: its name (name_of(), or "a" and its place if it was added).
struct PlacedBranch {
    std::string name;
    Place place;
};

constexpr char const* kTrunkName = "trunk"; // Of the axis that bears all others.

// How high a drawing is, its trunk's foot included: what TreeOptions::height_mm becomes.
double drawn_height(Skeleton const& skeleton);

// A tree in space.
struct Tree {
    Plant plant;
    std::vector<std::string> axis_names; // Of each axis: names from the trunk on, as "b3/L7".
    // Of the trunk's branches, then of the first system's of each further level.
    std::vector<std::vector<PlacedBranch>> arrangements;
    std::size_t leaves = 0;
    std::size_t sprays = 0;

    // What a person counts: axes, twigs and leaves.
    std::size_t element_count() const { return plant.axes.size() + sprays + leaves; }
};

// Turns a flat skeleton into a tree: the branches of each parent are spread around it, with others
// between them that end at the crown's surface (crown_surface.h), and twigs with leaves stand on
// the last ones. The drawing's plane becomes the plane y = 0, seen from below y; the trunk's foot
// is the origin. The plant passes check_plant().
Tree make_tree(Skeleton const& skeleton, TreeOptions const& options = {});

} // namespace tractus::silhouette
