#pragma once

#include "engine/methods/self_organising/beginning.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// A part of a tree's life: years by itself, or along a stroke of the brush.
struct LifePart {
    int years = 1;    // 1 to kMostYears.
    Stroke stroke {}; // World frame. Empty: the tree grows by itself, by light.
    // The ball's radius on the desk, at no pressure and at full pressure.
    double least_radius_mm = 8;
    double most_radius_mm = 40;
    bool waits_outside = false;  // See BrushSweep.
    double seconds_per_year = 0; // Of the pen's time; 0: the years divide the stroke evenly.
    // Where the tree stood and how many world millimetres a plant millimetre was when the stroke
    // was drawn. Set by the edits.
    Vec3 stands_at_mm = Vec3::Zero();
    double scale = 0.1;
};

// What a self-organised tree is made from: its life so far. It is grown from that anew whenever it
// is needed; the same life gives the same tree.
struct GrownTree {
    Habit habit {};
    std::uint64_t seed = 1;
    std::vector<LifePart> life {};
    SharedBeginning start {}; // The plant that it grew from; null for a tree grown from a seed.
};

// Adds a tree that begins to grow: where the stroke begins or, by itself, at the world's origin. It
// becomes the active plant.
struct PlantTree {
    static scene::EditKind const kKind;

    Habit habit {};
    std::uint64_t seed = 1;
    // A document whose scale nobody has set keeps this one. 0: it has none of its own, and the
    // first plant of a document is fitted into the drawing volume.
    double scale = 0;
    LifePart first {};
    scene::ItemId id = 0; // The plant's; 0: it has none yet.
};

// A tree goes on growing.
struct GrowOn {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    LifePart next {};
};

// Lets a plant of any method grow on as a tree of a habit. Its axes become living wood in the shape
// that strokes and grafts have given them; the plant then has no strokes, indicators or grafts.
struct GrowFrom {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Habit habit {};
    std::uint64_t seed = 1;
    LifePart next {};
};

// Lets a tree live the same life with another habit or by another chance.
struct ChangeHabit {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Habit habit {};
    std::uint64_t seed = 1;
};

// Fail, as the user's fault, for a part of a life out of range, and a tree that would be too old.
Result<void> check_life(LifePart const& part);
Result<void> check_age(GrownTree const& tree);

// Grows the tree from its beginning. Fails, as the user's fault, for a habit or a life out of
// range, and a stroke that is not in memory.
Result<GrowingTree> grow_tree(GrownTree const& tree, scene::LoadOptions const& options = {});

// The same as a plant; axes keep their keys as the tree lives longer.
Result<scene::BuiltSource> build_tree(GrownTree const& tree, scene::LoadOptions const& options);

// What stands under a plant; null for a source of another kind.
scene::PlantSource source_of(GrownTree tree);
GrownTree const* grown_tree_of(scene::PlantSource const& source);

} // namespace tractus::self_organising
