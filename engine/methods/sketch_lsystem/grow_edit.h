#pragma once

#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/model_rule.h"
#include "engine/methods/sketch_lsystem/rule.h"
#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/stroke.h"
#include "engine/stroke/upright_sheet.h"

#include <array>
#include <optional>
#include <vector>

namespace tractus::sketch {

// Edit: adds a plant that a rule grows along a stroke (Ijiri et al. 2006). The plant is rooted
// where the stroke begins and becomes the active plant.
struct GrowAlongStroke {
    static scene::EditKind const kKind;

    Rule rule {};
    Stroke stroke {}; // The drawn stroke, world frame.
    // Surface on which the stroke was drawn; must not be Decided.
    StrokeSurface surface = StrokeSurface::Space;
    Leaves leaves = Leaves::Leafy;
    // World millimetres per plant millimetre. A document whose scale has not been set adopts this
    // value.
    double scale = 0.1;
    scene::ItemId id = 0; // Id of the new plant; 0: not yet assigned.
    // Model that grows instead of the rule, if it is set. Only the rule's limit is used then, and
    // the model decides about leaves.
    ModelRule model {};
    // True if the pen drew the stroke from the plant's top to its foot; the pen's samples are then
    // stored in reverse order (foot_first.h).
    bool is_drawn_reversed = false;
};

// The lengths of the drawn axis's segments on the desk. Fails with a user error for a rule out of
// range or a model that breaks the contract of axis_contract.h.
Result<SegmentLengths> lengths_of(GrowAlongStroke const& edit);

// Writes the edit's plant as a model in cpfg's language. Fails like lengths_of() and with a user
// error for a stroke that is too short for one segment.
Result<lsystem::ModelSource> model_of(GrowAlongStroke const& edit);

// Grows the edit's model to a plant whose origin is the start of the stroke. Fails like model_of(),
// and if the model exceeds the limits in `options`, has more internodes than the rule's limit, or
// grows an axis other than the drawn one.
Result<scene::BuiltSource> build_sketch(GrowAlongStroke const& edit,
                                        scene::LoadOptions const& options);

// The nodes of the drawn axis in the plant's frame, in millimetres on the desk. Fails like
// model_of().
Result<std::vector<Vec3>> drawn_nodes_mm(GrowAlongStroke const& edit);

// Convert an edit to a plant's source and back. sketch_of() returns null for a source of another
// kind.
scene::PlantSource source_of(GrowAlongStroke const& edit);
GrowAlongStroke const* sketch_of(scene::PlantSource const& source);

// How much laterals vary between the plants of a collection whose spread is 1: standard deviations
// of the rule's angle, of its ratios (relative), and of its twists. No deviation exceeds
// kMaxDeviations standard deviations.
struct RuleSpread {
    double angle_deg = 6;
    double share = 0.06;
    double twist_deg = 10;
};
constexpr RuleSpread kRuleSpread {};
constexpr double kMaxDeviations = 2;

// Lists the fields of a rule for session files, named by the letters of rule files.
void list_rule(scene::Fields& fields, Rule& rule);

// Lists the fields of a model for session files; if the model is not set, only its empty text.
void list_model(scene::Fields& fields, ModelRule& model);

// Names of the values of Leaves and StrokeSurface in session files, in the order of the
// enumerators. An edit never has the value "decided".
inline constexpr std::array kLeavesWords { "bare", "leafy" };
inline constexpr std::array kSurfaceWords { "space", "paper", "decided" };

// The plant's position in the world frame: the start of the stroke or, for a stroke drawn on paper,
// the point of the desk below that start.
Vec3 stands_at_mm(GrowAlongStroke const& edit);

// The plant's position on the paper that the stroke was drawn on; no value for a stroke drawn in
// space.
std::optional<Vec2> paper_position_mm(GrowAlongStroke const& edit);

} // namespace tractus::sketch
