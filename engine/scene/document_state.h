#pragma once

#include "engine/base/result.h"
#include "engine/base/shared_list.h"
#include "engine/base/shared_vector.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/anchored.h"
#include "engine/scene/back_picture.h"
#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/season.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/association.h"
#include "engine/variation/motion_indicator.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::scene {

// A plant that was put on a branch of another and is a part of it since.
struct Graft {
    PartPrefix prefix {}; // What addresses in it begin with; by the ids of the plants that it was.
    std::string name {};  // As of PlantState, as the next ones.
    PlantSource source {};
    std::uint64_t source_edit = 0;
    std::optional<Vec2> paper_mm {};
    SetGrowth growth {}; // For when it is taken off; until then it grows as what bears it does.

    SegmentAddress at {}; // The segment on whose end it stands. Where there is none it waits.
    // From its own frame to the frame of what bears it, both at rest: a rotation vector (axis times
    // angle, radians), and from the segment's end to its base.
    Vec3 turn_rad = Vec3::Zero();
    Vec3 base_mm = Vec3::Zero();

    bool operator==(Graft const& other) const; // Whether it is the same for what is built.
};

// One plant of a document: what was drawn and set, and nothing that follows from it.
struct PlantState {
    ItemId id = 0;       // Of the edit that added it.
    std::string name {}; // For people; usually the model's.
    PlantSource source {};
    std::uint64_t source_edit = 0;    // The number of the edit that brought the source.
    Vec3 stands_at_mm = Vec3::Zero(); // Its base. World frame.
    // Where its base is on the paper that it was drawn on (paper.h); no value: on none.
    std::optional<Vec2> paper_mm {};
    double paper_unit = 1;        // Of that paper: Paper::unit.
    bool is_hidden = false;       // Neither shown nor exported.
    std::string leaves {};        // The name of their sheet; empty: the source's own.
    std::vector<Graft> grafts {}; // In the order in which they were put on it.
    // Segments that are not shown, with all that they bear. What was drawn on them waits.
    std::vector<SegmentAddress> hidden_branches {};

    SharedVector<PathAddress> selection {};
    // In order: a later one overrides an earlier one. Each is at one path.
    SharedList<Anchored<variation::ShapingStroke>> strokes {};
    // Each at what it acts below, which its own list of segments does not say.
    std::vector<Anchored<variation::MotionIndicator>> indicators {};
    SetGrowth growth {};
};

// What all edits so far amount to: what was drawn and set. A value of which copies are cheap; the
// plants themselves are built from it (scene_builder.h).
struct DocumentState {
    // In the order in which they were added. Shared with earlier states, and changed by nobody: a
    // plant that is the same object has not changed.
    std::vector<std::shared_ptr<PlantState const>> plants {};
    ItemId active = 0; // The plant that takes what is drawn; 0 where there is none.
    // World millimetres per plant millimetre, of all plants alike. No value: such that the first
    // plant fits the drawing volume.
    std::optional<double> scale {};
    std::optional<Season> season {}; // No value: plants are as their sources give them.
    LeafSheets leaf_sheets {};       // Grown leaves that plants and seasons need.
    // The texts of the user's own grammars, by their names. Shared with earlier states.
    std::map<std::string, std::shared_ptr<std::string const>, std::less<>> leaf_grammars {};
    std::shared_ptr<BackPicture const> picture {}; // Null: none lies behind what is drawn.
    std::uint64_t last_edit = 0; // The number of edits so far: of it, ids of items are made.
};

// The number of a plant in the document's list; no value where there is none of this id.
std::optional<std::size_t> find_plant(DocumentState const& state, ItemId id);

// Like find_plant(), but fails, as the user's fault, where there is none.
Result<std::size_t> plant_number(DocumentState const& state, ItemId id);

// Null where the document has no plant.
PlantState const* active_plant(DocumentState const& state);

// Puts what `change` makes of it in the place of a plant.
void change_plant(DocumentState& state, std::size_t number,
                  std::function<void(PlantState& plant)> const& change);

// The same for the active plant. A document without plants gets one.
void change_active(DocumentState& state, std::function<void(PlantState& plant)> const& change);

// The id of the first item that the edit at work makes: the one that it has already or, where that
// is 0, one that tells its number.
ItemId take_id(DocumentState& state, ItemId own);

// Puts a source under the active plant: what becomes of its strokes and indicators is what `drawn`
// says. Drawn::Beside adds a plant of that id, which becomes the active one.
struct NewSource {
    std::string name {};
    PlantSource source {};
    Drawn drawn = Drawn::Forget;
    Vec3 stands_at_mm = Vec3::Zero(); // Of one that is added.
    std::optional<Vec2> paper_mm {};  // Likewise.
    double paper_unit = 1;
    ItemId id = 0;
};
DocumentState with_source(DocumentState state, NewSource added);

} // namespace tractus::scene
