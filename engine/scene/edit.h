#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/plant/skeleton_lines.h"
#include "engine/scene/anchored.h"
#include "engine/scene/edit_kind.h"
#include "engine/scene/plant_source.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/association.h"
#include "engine/variation/growth.h"
#include "engine/variation/motion_indicator.h"
#include "engine/variation/select_branches.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::scene {

struct BuiltPlant;

// The user's edits, as values. A document is the result of applying its edits in order, so each
// edit contains everything needed to repeat it: the text of a model, the tips of a stroke, the
// chosen segments. Each struct below is one kind of edit (edit_kind.h).

// What happens to strokes and indicators when the source of a plant changes.
enum class Drawn {
    Forget, // Strokes and indicators are removed, as the new source is a different plant.
    // The new source is an edited form of the same plant. Items drawn on branches move to the
    // branches at the same addresses (branch_address.h). Items without such a branch become
    // orphans: they have no effect until a later edit brings the branch back.
    Keep,
    Beside, // The source becomes that of an additional plant.
};

// Sets an L-system model as the source of a plant.
struct LoadModel {
    static EditKind const kKind;

    lsystem::ModelSource source;
    // Texts of the files that the model includes, by name.
    std::map<std::string, std::string> includes {};
    std::optional<int> steps {}; // Number of derivation steps. Default: as given in the model.
    std::uint64_t seed = 1;      // Seed of the model's stochastic rules.
    Drawn drawn = Drawn::Forget;
    // For Drawn::Beside: position of the plant's base, world frame.
    Vec3 stands_at_mm = Vec3::Zero();
    ItemId id = 0; // For Drawn::Beside: id of the plant; 0 if not assigned yet.

    bool operator==(LoadModel const&) const = default;
};

// Sets the lines of a skeleton drawn by another program as the source of a plant
// (skeleton_lines.h).
struct LoadSkeleton {
    static EditKind const kKind;

    std::string name {};
    std::vector<SkeletonPiece> lines {};
    Drawn drawn = Drawn::Forget;
    // For Drawn::Beside: the plant's base and id, as in LoadModel.
    Vec3 stands_at_mm = Vec3::Zero();
    ItemId id = 0;

    bool operator==(LoadSkeleton const&) const = default;
};

// Sets a file as the source of a plant: a measured plant, or one that another program stores as a
// graph, a list of cylinders or a skeleton (measured_source.h).
struct LoadMeasured {
    static EditKind const kKind;

    enum class Format {
        Mtg, // Multiscale tree graph (engine/plant/mtg.h).
        Qsm, // Quantitative structure model (engine/plant/qsm.h).
        Ply, // Skeleton in a PLY file (engine/plant/ply_skeleton.h).
    };

    std::string name {};
    std::string text {}; // Contents of the file: text or binary.
    Format format = Format::Mtg;
    Drawn drawn = Drawn::Forget;
    // For Drawn::Beside: the plant's base and id, as in LoadModel.
    Vec3 stands_at_mm = Vec3::Zero();
    ItemId id = 0;

    bool operator==(LoadMeasured const&) const = default;
};

// Each of these functions returns the edit that set the source, or null if the source is of another
// kind.
LoadModel const* loaded_model(PlantSource const& source);
LoadSkeleton const* loaded_skeleton(PlantSource const& source);
LoadMeasured const* loaded_measured(PlantSource const& source);

// Replaces the selection: the paths to which later strokes apply. Usually it is one path, or
// several if the pen left the choice of branch open (Streit 2006, section 4.1). An empty list
// clears the selection.
struct Select {
    static EditKind const kKind;

    // Paths given by segment numbers, as in sessions before format 4.
    variation::Selection paths {};
    std::vector<PathAddress> at {}; // Paths given by addresses.
};

// Returns the edit that selects these paths of a plant, by their addresses.
Select select_paths(BuiltPlant const& plant, variation::Selection const& paths);

// Applies a stroke to each selected path, to the path's descendants, or to both (Streit 2006,
// section 4.3).
struct Associate {
    static EditKind const kKind;

    Stroke stroke;
    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
    // Share of the hand's detail that the stroke keeps, from 0 (smooth) to 1 (as drawn).
    double detail_weight = 1;
    variation::StrokeLaying laying = variation::StrokeLaying::LeastTwist;
    ItemId id = 0; // Id of the stroke on the first selected path; 0 if not assigned yet.
    // True if the stroke was drawn from tip to foot, so that `stroke` is its reverse
    // (foot_first.h).
    bool is_drawn_reversed = false;
};

// The drawn items that an edit applies to.
struct Items {
    std::vector<ItemId> ids {};
    // Positions in the list of items, which sessions before format 4 use instead of ids.
    std::vector<std::uint64_t> numbers {};

    bool empty() const { return ids.empty() && numbers.empty(); }
};

// Edits of existing strokes. Each names at least one stroke.

// Redraws a part of the strokes by drawing over them (oversketch.h).
struct Oversketch {
    static EditKind const kKind;

    Items strokes;
    Stroke over;
};

// Sets how much of the hand's detail the strokes keep, from 0 (smooth) to 1 (as drawn).
struct SmoothStroke {
    static EditKind const kKind;

    Items strokes;
    double detail_weight = 0;
};

// Reverses strokes: what was the tip becomes the foot.
struct TurnStroke {
    static EditKind const kKind;

    Items strokes;
};

// Deletes strokes. Earlier strokes that they overrode take effect again.
struct DeleteStroke {
    static EditKind const kKind;

    Items strokes;
};

// Erases ranges of tips of each stroke (erase_tips.h). A whole stroke is removed by DeleteStroke
// instead.
struct EraseTips {
    static EditKind const kKind;

    Items strokes;
    // Ranges of tips, in ascending order; indices count in the stroke's present form.
    std::vector<TipRange> ranges;
};

// Adds a motion indicator (Streit 2006, section 4.4).
struct Indicate {
    static EditKind const kKind;

    variation::MotionIndicator indicator;
    // Addresses of the segments below which the indicator acts, besides those in `indicator`.
    std::vector<SegmentAddress> below {};
    ItemId id = 0; // Id of the indicator; 0 if not assigned yet.
};

// Replaces an indicator. An indicator identified by its id keeps acting below the same segments.
struct ChangeIndicator {
    static EditKind const kKind;

    // Id of the indicator. In sessions before format 4 it is 0, and `number` is the indicator's
    // position in the list of indicators.
    ItemId which = 0;
    std::uint64_t number = 0;
    variation::MotionIndicator indicator;
};

struct DeleteIndicator {
    static EditKind const kKind;

    ItemId which = 0; // Id of the indicator; if 0, `number` is its position, as in ChangeIndicator.
    std::uint64_t number = 0;
};

// Sets the growth parameters of the active plant.
struct SetGrowth {
    static EditKind const kKind;

    variation::GrowthParameters parameters;
    std::uint64_t seed = 1; // Seed of the random variations.
    double variability = 1; // Factor on the variation parameters; see at_variability().
    double age = 1;         // Age of the plant, 0 (young) to 1; see Grower::grow().
};

// Edits of the document's list of plants; their kinds are defined in plant_edits.cpp.

// Makes a plant the active one, to which drawing then applies.
struct ActivatePlant {
    static EditKind const kKind;

    ItemId plant = 0;
};

// Moves the base of a plant in the drawing volume.
struct MovePlant {
    static EditKind const kKind;

    ItemId plant = 0;
    Vec3 to_mm = Vec3::Zero(); // New position of the plant's base, world frame.
};

// Adds a copy of a plant with everything drawn and set on it, and makes the copy active.
struct CopyPlant {
    static EditKind const kKind;

    ItemId plant = 0;
    Vec3 stands_at_mm = Vec3::Zero(); // Position of the copy's base, world frame.
    ItemId id = 0;                    // Id of the copy; 0 if not assigned yet.
};

// Hides a plant from display and export, or shows it again.
struct HidePlant {
    static EditKind const kKind;

    ItemId plant = 0;
    bool hidden = true;
};

struct NamePlant {
    static EditKind const kKind;

    ItemId plant = 0;
    std::string name {};
};

// Removes a plant with everything drawn on it. If the plant was active, the one before it in the
// list becomes active.
struct RemovePlant {
    static EditKind const kKind;

    ItemId plant = 0;
};

// Edits of plants' parts; their kinds are defined in graft_edits.cpp.

// Grafts a plant onto a branch of another plant, of which it becomes a part: the part moves, grows,
// varies and is exported with the whole plant. Everything drawn on the grafted plant is kept. If
// the grafted plant was active, the other plant becomes active.
struct GraftPlant {
    static EditKind const kKind;

    ItemId plant = 0;             // Id of the plant to graft; 0: the active one.
    ItemId onto = 0;              // Id of the plant that it is grafted onto.
    SegmentAddress at {};         // Segment of `onto` to whose end the plant is attached.
    Vec3 turn_rad = Vec3::Zero(); // Rotation and displacement of the part; see Graft.
    Vec3 base_mm = Vec3::Zero();
};

// Turns a grafted part back into a separate plant, with everything drawn on it, and makes that
// plant active.
struct TakeOffGraft {
    static EditKind const kKind;

    ItemId plant = 0;                 // Id of the plant that contains the part.
    ItemId graft = 0;                 // Id that the part had as a plant.
    Vec3 stands_at_mm = Vec3::Zero(); // Position of the plant's base, world frame.
    ItemId id = 0;                    // New id of the plant; 0 if not assigned yet.
};

// Hides a segment of a plant together with all its descendants, or shows them again.
struct HideBranch {
    static EditKind const kKind;

    ItemId plant = 0;
    SegmentAddress at {};
    bool hidden = true;
};

// Sets the scale at which all plants of the document are displayed.
struct SetScale {
    static EditKind const kKind;

    double scale = 0.1; // World millimetres per plant millimetre; above 0.
};

// Edits of leaves and season; their kinds are defined in leaf_edits.cpp and season_edits.cpp.

// Stores grown leaves in the document, for the plants and seasons that use them. A session thus
// reproduces its leaves unchanged.
struct KeepLeaves {
    static EditKind const kKind;

    // Name of the sheet, which encodes how its leaves were grown (leaf_sheet.h).
    std::string name {};
    std::string sheet {}; // Text of the sheet.
};

// Stores a leaf grammar of the user's in the document, so that its leaves can be grown at other
// ages.
struct KeepGrammar {
    static EditKind const kKind;

    std::string name {}; // The name by which leaf sheets refer to it.
    std::string text {};
};

// Replaces the leaves of a plant (foliated_plant.h).
struct SetFoliage {
    static EditKind const kKind;

    ItemId plant = 0;
    std::string leaves {}; // Name of a sheet in the document; empty for the plant's own leaves.
};

// Shows all plants of the document at a time of the year (season.h).
struct SetSeason {
    static EditKind const kKind;

    // 1 to below 13; 0: no season, so that plants are shown as their sources define them.
    double month = 0;
    double fallen = 0.25; // Share of the fallen leaves that are displayed on the ground, 0 to 1.
};

// An edit of unknown kind, from a newer version of the program or from one with more methods. Its
// fields are those of its record (app/session/edit_record.h), kept unchanged. Applying it fails.
struct UnknownEdit {
    static EditKind const kKind;

    std::string word;
    std::string fields;
    std::string numbers;
    std::string why; // What is unknown about the edit, in one sentence.
};

// Returns the kinds of edits that engine/scene defines, without UnknownEdit.
EditKinds core_edit_kinds();

} // namespace tractus::scene
