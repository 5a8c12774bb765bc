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

// Adds a plant that a rule grows along a stroke (Ijiri et al. 2006). It stands where the pen came
// down and becomes the active one.
struct GrowAlongStroke {
    static scene::EditKind const kKind;

    Rule rule {};
    Stroke stroke {};                             // World frame.
    StrokeSurface surface = StrokeSurface::Space; // Never Decided.
    Leaves leaves = Leaves::Leafy;
    // World millimetres per plant millimetre: what was drawn is a plant of so many times its size.
    // A document whose scale nobody has set keeps this one.
    double scale = 0.1;
    scene::ItemId id = 0; // The plant's; 0: it has none yet.
    // Grows in the rule's place if it is set: of the rule only its limit counts then, and leaves
    // are as the model has them.
    ModelRule model {};
};

// How long the segments of the drawn axis are, on the desk. Fails, as the user's fault, for a rule
// that is out of its ranges and a model that does not keep its contract.
Result<SegmentLengths> lengths_of(GrowAlongStroke const& edit);

// The edit's plant as a model in cpfg's language. Fails like lengths_of(), and, as the user's
// fault, for a stroke along which the rule is not applied once.
Result<lsystem::ModelSource> model_of(GrowAlongStroke const& edit);

// Grows that model: a plant frame whose origin is where the pen came down. Fails like model_of(),
// where the model takes more than the options allow, and where its plant has more internodes than
// the limit or another axis than was drawn.
Result<scene::BuiltSource> build_sketch(GrowAlongStroke const& edit,
                                        scene::LoadOptions const& options);

// The nodes of the drawn axis, plant frame in millimetres on the desk. Fails like model_of().
Result<std::vector<Vec3>> drawn_nodes_mm(GrowAlongStroke const& edit);

// What the edit puts into a document, and the edit that has put a source there; null for a source
// of another kind.
scene::PlantSource source_of(GrowAlongStroke const& edit);
GrowAlongStroke const* sketch_of(scene::PlantSource const& source);

// How far laterals differ between the plants of a collection whose spread is 1: standard deviations
// of a rule's angle, of its ratios, as shares of them, and of its twists. None differs by more than
// twice that.
struct RuleSpread {
    double angle_deg = 6;
    double share = 0.06;
    double twist_deg = 10;
};
constexpr RuleSpread kRuleSpread {};
constexpr double kMostDeviations = 2;

// Lists the fields of a rule by the letters of rule files.
void list_rule(scene::Fields& fields, Rule& rule);

// Lists the fields of a model; none but its text where there is none.
void list_model(scene::Fields& fields, ModelRule& model);

// The words for Leaves, and for surfaces, in their order. A surface that is not decided is in no
// edit.
inline constexpr std::array kLeavesWords { "bare", "leafy" };
inline constexpr std::array kSurfaceWords { "space", "paper", "decided" };

// Where the plant stands. World frame. On paper on the desk, below where the pen came down.
Vec3 stands_at_mm(GrowAlongStroke const& edit);

// Where that is on the paper that the stroke was drawn on; no value: it was drawn in space.
std::optional<Vec2> stands_on_paper_mm(GrowAlongStroke const& edit);

} // namespace tractus::sketch
