#pragma once

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/plant/bark.h"
#include "engine/plant/leaf_spray.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::silhouette {

// Arrangement of the branches of one level around their parents.
struct LevelOptions {
    Pattern pattern = Pattern::Even;
    double added = 1.5; // Number of added branches per branch visible in the plane; 0 or more.
    int proposals = 3000;
    ArrangementOptions::Nodes nodes = ArrangementOptions::Nodes::Whole;
    // Style that gives the number, positions and angles of the branches, if it is set; `added` is
    // then ignored. Inferred branches move to the nearest positions of the style; drawn ones stay.
    BranchStyle style {};
};

struct TreeOptions {
    std::vector<LevelOptions> levels { {},
                                       // The last entry applies to all deeper levels.
                                       { .added = 0.5, .proposals = 600 } };
    BranchingAngles angles {}; // Branching angles of added branches.
    double height_mm = 8000;   // Height of the drawing in plant millimetres.
    std::uint64_t seed = 1;
    // Number of twigs on a branch of the last level whose length is 7 % of the height.
    std::size_t sprays = 12;
    SprayForm leaf {};
    Vec3f leaf_color { 0.25f, 0.42f, 0.13f };
    Vec3f bark_color { 0.34f, 0.27f, 0.2f }; // Used where `bark` is Furrowed.
    BarkKind bark = BarkKind::Furrowed;      // Gives the bark its colours, too.
    double tip_radius_of_height = 0.0006;
    // True: as seen from the drawing plane, the leaves fill the outline and stay inside of it
    // (leaf_fill.h).
    bool leaves_reach_outline = false;
};

// A branch's position around its parent. Its name comes from name_of(), or is "a" and the position
// for an added branch.
struct PlacedBranch {
    std::string name;
    Place place;
};

constexpr char const* kTrunkName = "trunk"; // Name of the tree's main axis.

// Height of a drawing including the trunk's foot; the plant's height TreeOptions::height_mm
// corresponds to it.
double drawn_height(Skeleton const& skeleton);

// A tree in space.
struct Tree {
    Plant plant;
    // Path of names of each axis, from the trunk on, such as "b3/L7".
    std::vector<std::string> axis_names;
    // Arrangements of the trunk's branches, then of the first system of each further level.
    std::vector<std::vector<PlacedBranch>> arrangements;
    std::size_t leaves = 0;
    std::size_t sprays = 0;
    // The crown's outline as seen from the drawing plane, plant millimetres (x and z).
    std::vector<Vec2> outline_mm {};

    // Number of parts as users count them: axes, twigs and leaves.
    std::size_t element_count() const { return plant.axes.size() + sprays + leaves; }
};

// Turns a flat skeleton into a tree: branches are distributed around each parent, further branches
// that end at the crown's surface (crown_surface.h) are added between them, and twigs with leaves
// are placed on the branches of the last level. The drawing plane becomes y = 0, viewed from
// negative y; the trunk's foot is the origin. The plant passes check_plant().
Tree make_tree(Skeleton const& skeleton, TreeOptions const& options = {});

} // namespace tractus::silhouette
