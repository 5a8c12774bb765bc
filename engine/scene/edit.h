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

// What the user did, as values. A document is the fold of its edits, so an edit holds all that is
// needed to do it again: the model's text, the pen's tips, the chosen segments. Each struct is a
// kind of edit (edit_kind.h).

// What becomes of what was drawn when the plant changes.
enum class Drawn {
    Forget, // Another plant: strokes and indicators go.
    Keep,   // The same plant, edited: what was drawn on branches goes to those at the same place
          // (branch_address.h). Where there is none it is orphaned: kept without effect, and found
          // again when a later edit brings the branch back.
    Beside, // The plant is one more, beside those that are there.
};

// Takes a base plant from an L-system.
struct LoadModel {
    static EditKind const kKind;

    lsystem::ModelSource source;
    std::map<std::string, std::string> includes {}; // What the model includes, by name: the texts.
    std::optional<int> steps {};                    // Derivation steps; no value: the model's own.
    std::uint64_t seed = 1;                         // Of the model's stochastic rules.
    Drawn drawn = Drawn::Forget;
    Vec3 stands_at_mm = Vec3::Zero(); // With Drawn::Beside: the base of the plant. World frame.
    ItemId id = 0;                    // Likewise: of the plant; 0: it has none yet.

    bool operator==(LoadModel const&) const = default;
};

// Takes a base plant from the lines that another program drew of it (skeleton_lines.h).
struct LoadSkeleton {
    static EditKind const kKind;

    std::string name {};
    std::vector<SkeletonPiece> lines {};
    Drawn drawn = Drawn::Forget;
    Vec3 stands_at_mm = Vec3::Zero(); // As of LoadModel, as the next one.
    ItemId id = 0;

    bool operator==(LoadSkeleton const&) const = default;
};

// Takes a base plant from the file of a plant that was measured, or that another program keeps as a
// graph, a list of cylinders or a skeleton (measured_source.h).
struct LoadMeasured {
    static EditKind const kKind;

    enum class Format {
        Mtg, // engine/plant/mtg.h
        Qsm, // engine/plant/qsm.h
        Ply, // engine/plant/ply_skeleton.h
    };

    std::string name {};
    std::string text {}; // All of the file: bytes, if it is a binary one.
    Format format = Format::Mtg;
    Drawn drawn = Drawn::Forget;
    Vec3 stands_at_mm = Vec3::Zero(); // As of LoadModel, as the next one.
    ItemId id = 0;

    bool operator==(LoadMeasured const&) const = default;
};

// The edit that has put a source into a document; null for a source of another kind.
LoadModel const* loaded_model(PlantSource const& source);
LoadSkeleton const* loaded_skeleton(PlantSource const& source);
LoadMeasured const* loaded_measured(PlantSource const& source);

// Chooses what the next associations go to, in place of what was chosen. Usually one path, or one
// for each branch that the pen left undetermined (Streit 2006, section 4.1); none chooses nothing.
struct Select {
    static EditKind const kKind;

    variation::Selection paths {};  // By their segments, as sessions before format 4 say it, or
    std::vector<PathAddress> at {}; // by where they are.
};

// Paths of a plant, said by where they are.
Select select_paths(BuiltPlant const& plant, variation::Selection const& paths);

// Lets a stroke shape each selected path, its descendants, or both (Streit 2006, section 4.3).
struct Associate {
    static EditKind const kKind;

    Stroke stroke;
    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
    double detail_weight = 1; // See Association.
    variation::StrokeLaying laying = variation::StrokeLaying::LeastTwist;
    ItemId id = 0; // Of the stroke of the first path; 0: it has none yet.
};

// Which of the things drawn so far an edit is about.
struct Items {
    std::vector<ItemId> ids {};
    // Sessions before format 4 say it by the numbers in the list of that time.
    std::vector<std::uint64_t> numbers {};

    bool empty() const { return ids.empty() && numbers.empty(); }
};

// The next ones edit strokes that shape something already, at least one.

// Redraws a part of them (oversketch.h).
struct Oversketch {
    static EditKind const kKind;

    Items strokes;
    Stroke over;
};

// From here on keeps so much of the hand in them, 0 (smooth) to 1 (as drawn).
struct SmoothStroke {
    static EditKind const kKind;

    Items strokes;
    double detail_weight = 0;
};

// Takes them away; what they overrode counts again.
struct DeleteStroke {
    static EditKind const kKind;

    Items strokes;
};

// Takes these tips of each of them away (erase_tips.h); where none would be left that shape
// anything, DeleteStroke takes the whole.
struct EraseTips {
    static EditKind const kKind;

    Items strokes;
    std::vector<TipRange> ranges; // Of its tips as they are now, in order.
};

// Adds one motion indicator (Streit 2006, section 4.4).
struct Indicate {
    static EditKind const kKind;

    variation::MotionIndicator indicator;
    std::vector<SegmentAddress> below {}; // What it acts below, if `indicator` does not say it.
    ItemId id = 0;                        // 0: it has none yet.
};

// Puts another in the place of an indicator. One that is named by its id stays at the segments that
// it acts below.
struct ChangeIndicator {
    static EditKind const kKind;

    ItemId which = 0; // 0, in sessions before format 4: the one with this number in their list.
    std::uint64_t number = 0;
    variation::MotionIndicator indicator;
};

struct DeleteIndicator {
    static EditKind const kKind;

    ItemId which = 0; // As of ChangeIndicator.
    std::uint64_t number = 0;
};

// Sets how plants grow from here on.
struct SetGrowth {
    static EditKind const kKind;

    variation::GrowthParameters parameters;
    std::uint64_t seed = 1; // Of the variations.
    double variability = 1; // At which the parameters count; see at_variability().
    double age = 1;         // See Grower::grow().
};

// The plants of a document. Their kinds are in plant_edits.cpp.

// From here on what is drawn goes to this plant.
struct ActivatePlant {
    static EditKind const kKind;

    ItemId plant = 0;
};

// Puts the base of a plant somewhere else in the drawing volume.
struct MovePlant {
    static EditKind const kKind;

    ItemId plant = 0;
    Vec3 to_mm = Vec3::Zero(); // World frame.
};

// Adds a plant that is like another in all that was drawn and set; it becomes the active one.
struct CopyPlant {
    static EditKind const kKind;

    ItemId plant = 0;
    Vec3 stands_at_mm = Vec3::Zero(); // World frame.
    ItemId id = 0;                    // Of the copy; 0: it has none yet.
};

// A hidden plant is neither shown nor exported, until it is shown again.
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

// Takes a plant away with all that was drawn on it. The plant before it becomes the active one if
// it was that.
struct RemovePlant {
    static EditKind const kKind;

    ItemId plant = 0;
};

// Parts of plants. Their kinds are in graft_edits.cpp.

// Puts a plant on a branch of another, of which it is a part from then on: what is drawn below
// carries it, and it grows, varies and goes into files with what bears it. What was drawn on it
// stays; the other one becomes the active plant if it was that.
struct GraftPlant {
    static EditKind const kKind;

    ItemId plant = 0;             // 0: the active one.
    ItemId onto = 0;              // Another.
    SegmentAddress at {};         // Of `onto`: the segment on whose end it shall stand.
    Vec3 turn_rad = Vec3::Zero(); // As in Graft, as the next one.
    Vec3 base_mm = Vec3::Zero();
};

// Makes a part that was put on a plant a plant of its own again, which becomes the active one. What
// was drawn on it goes with it.
struct TakeOffGraft {
    static EditKind const kKind;

    ItemId plant = 0;                 // What bears it,
    ItemId graft = 0;                 // and the id that it had as a plant.
    Vec3 stands_at_mm = Vec3::Zero(); // World frame.
    ItemId id = 0;                    // From now on; 0: it has none yet.
};

// Hides a segment of a plant and all that it bears, or shows one that is hidden.
struct HideBranch {
    static EditKind const kKind;

    ItemId plant = 0;
    SegmentAddress at {};
    bool hidden = true;
};

// The size in which all plants of the document are shown.
struct SetScale {
    static EditKind const kKind;

    double scale = 0.1; // World millimetres per plant millimetre; above 0.
};

// Leaves and seasons. Their kinds are in leaf_edits.cpp and season_edits.cpp.

// Keeps grown leaves for the plants and seasons that need them: a session has them as they were.
struct KeepLeaves {
    static EditKind const kKind;

    std::string name {};  // Of the sheet, which says what they are (leaf_sheet.h).
    std::string sheet {}; // Its text.
};

// Keeps a leaf grammar that does not come with the program, for leaves of other ages.
struct KeepGrammar {
    static EditKind const kKind;

    std::string name {}; // As sheets of its leaves name it.
    std::string text {};
};

// Gives a plant other leaves (dressed_plant.h).
struct DressPlant {
    static EditKind const kKind;

    ItemId plant = 0;
    std::string leaves {}; // The name of a sheet that the document keeps; empty: the plant's own.
};

// Shows all plants of the document at a time of the year (season.h).
struct SetSeason {
    static EditKind const kKind;

    double month = 0;     // 1 to below 13; 0: as the plants' sources give them.
    double fallen = 0.25; // Share of the fallen leaves that are seen on the ground, 0 to 1.
};

// An edit that another tractus has made, a newer one or one with more methods, in the words of its
// record (app/session/edit_record.h). It is kept as it is, and refused when it is to be applied.
struct UnknownEdit {
    static EditKind const kKind;

    std::string word;
    std::string fields;
    std::string numbers;
    std::string why; // A sentence: what of it is unknown.
};

// The kinds above but for the last, which stands for all that are not in a table.
EditKinds core_edit_kinds();

} // namespace tractus::scene
