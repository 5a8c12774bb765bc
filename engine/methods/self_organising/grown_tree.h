#pragma once

#include "engine/methods/self_organising/beginning.h"
#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::self_organising {

class Stand; // Defined in stand.h.

// A period of a tree's life: some years of growth, either without a brush or along a brush stroke;
// or a stroke that prunes the tree or clears space.
struct LifePeriod {
    enum class Kind {
        Grow,
        Prune, // The stroke cuts off what it touches (prune.h).
        // The stroke clears space: the tree grows as if no earlier brush stroke had covered this
        // space. A later stroke may cover it again.
        Clear,
    } kind
        = Kind::Grow;
    // Duration of growth in years, 1 to kMaxYears; ignored for Prune and Clear.
    int years = 1;
    // Brush stroke, world frame. Empty (only for Kind::Grow): the tree grows without a brush, and
    // its buds compete for light.
    Stroke stroke {};
    bool is_volume = false; // See BrushSweep::is_volume.
    // Radius of the brush at zero and at full pen pressure, in millimetres on the desk.
    double min_radius_mm = 8;
    double most_radius_mm = 40;
    bool waits_outside = false; // See BrushSweep::waits_outside.
    // Seconds of drawing that count as one year; 0: the years divide the stroke's duration evenly.
    double seconds_per_year = 0;
    // True if the stroke was drawn from the tree's top to its foot, so that `stroke` is its reverse
    // (foot_first.h).
    bool is_drawn_reversed = false;
    // The tree's position and scale (world millimetres per plant millimetre) when the stroke was
    // drawn. The edit that adds the period sets both.
    Vec3 stands_at_mm = Vec3::Zero();
    double scale = 0.1;
    // The stand in which the tree grows, and the tree's index there; null: the tree grows alone.
    // GrowStand sets both.
    std::shared_ptr<Stand const> stand {};
    std::size_t place_in_stand = 0;
};

// Source of a self-organising tree: its life so far. The tree is grown anew from this source
// whenever it is needed; equal sources give equal trees.
struct GrownTree {
    Habit habit {};
    std::uint64_t seed = 1;
    std::vector<LifePeriod> life {};
    // The plant from which the tree continued to grow; null for a tree grown from a seed.
    SharedBeginning start {};
};

// Edit: adds a tree at the beginning of its first stroke or, without a stroke, at the world's
// origin. The tree becomes the active plant.
struct PlantTree {
    static scene::EditKind const kKind;

    Habit habit {};
    std::uint64_t seed = 1;
    // Scale that a document adopts if its scale has not been set. 0: the document's first plant is
    // fitted into the drawing volume instead.
    double scale = 0;
    LifePeriod first {};
    scene::ItemId id = 0; // Id of the new plant; 0: not yet assigned.
};

// Edit: adds a period, of growth, pruning or clearing, to a tree's life.
struct GrowOn {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    LifePeriod next {};
};

// Edit: converts a plant of any method to a self-organising tree that continues to grow. Its axes
// become living wood in the shape that strokes and grafts have given them; strokes, indicators and
// grafts are then removed.
struct GrowFrom {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Habit habit {};
    std::uint64_t seed = 1;
    LifePeriod next {};
    // Keys of the axes that are kept; their ancestors are kept with them. Empty: all axes are kept.
    // Only for a plant whose axes have keys.
    std::vector<std::uint32_t> kept_axes {};
};

// Edit: regrows a tree through the same periods of life with another habit or another seed.
struct ChangeHabit {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    Habit habit {};
    std::uint64_t seed = 1;
};

// Edit: reverses the newest brush stroke along which a tree has grown, and regrows the tree. If it
// is the stroke with which the tree began, the tree stands at the stroke's other end.
struct TurnBrushStroke {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
};

// The balls of the brush along a period's stroke, in the tree's frame. Fails if the stroke's
// samples are not in memory.
Result<std::vector<BrushBall>> brush_balls(LifePeriod const& part);

// Edit: lets all visible self-organising trees of a document grow on without a brush, beside each
// other (stand.h), while the other plants shade them.
struct GrowStand {
    static scene::EditKind const kKind;

    int years = 1;
};

// Number of years that a period takes; 0 for a period of pruning or clearing.
int years_of(LifePeriod const& part);

// check_life() checks a period's values, check_age() the total of a tree's years. Both fail with a
// user error.
Result<void> check_life(LifePeriod const& part);
Result<void> check_age(GrownTree const& tree);

// Grows the tree from its beginning through all periods of its life. `on_year` receives the tree at
// its beginning and after each year. Fails with a user error for a habit or life out of range and
// for a stroke whose samples are not in memory.
Result<GrowingTree> grow_tree(GrownTree const& tree, scene::LoadOptions const& options = {},
                              YearCallback const& on_year = {});

// Grows the tree and converts it to a plant. Axes keep their keys when the tree grows older.
Result<scene::BuiltSource> build_tree(GrownTree const& tree, scene::LoadOptions const& options);

// Convert a grown tree to a plant's source and back. grown_tree_of() returns null for a source of
// another kind.
scene::PlantSource source_of(GrownTree tree);
GrownTree const* grown_tree_of(scene::PlantSource const& source);

} // namespace tractus::self_organising
