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

struct DrawnLimb;

// A part that was added to a branch of a plant: another plant that was grafted there, or a limb
// that was drawn.
struct Graft {
    // Prefix of the addresses in this part, formed from the ids of the parts that contain it and
    // its own id.
    PartPrefix prefix {};
    // Name, source, edit number and paper position of the grafted plant, as in PlantState.
    std::string name {};
    PlantSource source {};
    std::uint64_t source_edit = 0;
    std::optional<Vec2> paper_mm {};
    // Growth parameters that the part gets back when it is taken off; until then it grows with the
    // whole plant.
    SetGrowth growth {};

    // The segment to whose end the part is attached. While that segment does not exist, the part is
    // not shown.
    SegmentAddress at {};
    // Transform from the part's frame to the whole plant's frame, both at rest: a rotation vector
    // (axis times angle, radians), and the displacement from the segment's end to the part's base.
    Vec3 turn_rad = Vec3::Zero();
    Vec3 base_mm = Vec3::Zero();

    // The limb, if the part is a drawn limb (limb_edits.h): it has no source and does not use
    // turn_rad and base_mm. Null if the part is a grafted plant. Immutable, and shared between
    // states.
    std::shared_ptr<DrawnLimb const> limb {};

    bool operator==(Graft const& other) const; // Compares only what affects the resulting plant.
};

// One plant of a document: what the user has drawn and set, without anything derived from that.
struct PlantState {
    ItemId id = 0;       // Id of the plant, given by the edit that added it.
    std::string name {}; // For display; usually the name of the model.
    PlantSource source {};
    std::uint64_t source_edit = 0;    // Number of the edit that set the source.
    Vec3 stands_at_mm = Vec3::Zero(); // Position of the plant's base, world frame.
    // Position of the base on the paper that the plant was drawn on (paper.h). No value if it was
    // not drawn on paper.
    std::optional<Vec2> paper_mm {};
    double paper_unit = 1;  // Scale (Paper::unit) of the paper that the plant was drawn on.
    bool is_hidden = false; // True: the plant is neither displayed nor exported.
    // Name of the leaf sheet that replaces the plant's leaves; empty for the leaves of the source.
    std::string leaves {};
    std::vector<Graft> grafts {}; // Added parts, in the order in which they were added.
    // Segments that are hidden with all their descendants. Items drawn on hidden segments have no
    // effect.
    std::vector<SegmentAddress> hidden_branches {};

    SharedVector<PathAddress> selection {};
    // Strokes in drawing order: a later stroke overrides an earlier one. Each stroke has one path.
    SharedList<Anchored<variation::ShapingStroke>> strokes {};
    // Each indicator has the paths below which it acts; its field MotionIndicator::below is not
    // used.
    std::vector<Anchored<variation::MotionIndicator>> indicators {};
    SetGrowth growth {};
};

// The result of all edits so far: everything that was drawn and set. A value with cheap copies.
// SceneBuilder builds the plants from it (scene_builder.h).
struct DocumentState {
    // The plants, in the order in which they were added. They are immutable and shared with earlier
    // states: a plant whose pointer is unchanged has not changed.
    std::vector<std::shared_ptr<PlantState const>> plants {};
    ItemId active = 0; // Id of the plant that new strokes are drawn on; 0 if there are no plants.
    // Scale of all plants: world millimetres per plant millimetre. Default: the scale at which the
    // first plant fits the drawing volume.
    std::optional<double> scale {};
    // Season in which plants are displayed. Default: plants are shown as their sources define them.
    std::optional<Season> season {};
    LeafSheets leaf_sheets {}; // Grown leaves that plants and seasons use, by name.
    // Texts of the user's leaf grammars, by name. Shared with earlier states.
    std::map<std::string, std::shared_ptr<std::string const>, std::less<>> leaf_grammars {};
    std::shared_ptr<BackPicture const> picture {}; // The background picture; null if there is none.
    std::uint64_t last_edit = 0; // Number of the latest edit; ids of new items are made from it.
};

// Returns the index of a plant in the document's list, or no value if no plant has this id.
std::optional<std::size_t> find_plant(DocumentState const& state, ItemId id);

// Like find_plant(), but fails with a user error if no plant has this id.
Result<std::size_t> plant_number(DocumentState const& state, ItemId id);

// Returns the active plant, or null if the document has no plant.
PlantState const* active_plant(DocumentState const& state);

// Replaces plant number `number` by a copy that `change` has modified.
void change_plant(DocumentState& state, std::size_t number,
                  std::function<void(PlantState& plant)> const& change);

// Like change_plant(), for the active plant. A document without plants gets a new one first.
void change_active(DocumentState& state, std::function<void(PlantState& plant)> const& change);

// Returns the id of the first item made by the current edit: `own`, or, if that is 0, an id derived
// from the number of the edit.
ItemId take_id(DocumentState& state, ItemId own);

// A new source for the active plant; `drawn` decides what happens to the plant's strokes and
// indicators. With Drawn::Beside it is instead the source of an additional plant, which becomes
// active.
struct NewSource {
    std::string name {};
    PlantSource source {};
    Drawn drawn = Drawn::Forget;
    Vec3 stands_at_mm = Vec3::Zero(); // Position of the base of an added plant, world frame.
    // Position of an added plant's base on paper, as in PlantState; also paper_unit.
    std::optional<Vec2> paper_mm {};
    double paper_unit = 1;
    ItemId id = 0;
};
DocumentState with_source(DocumentState state, NewSource added);

} // namespace tractus::scene
