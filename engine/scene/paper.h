#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/document_state.h"

#include <optional>

namespace tractus::scene {

// The tablet as a sheet of paper that stands upright in the drawing volume: what lies to the right
// on it lies to the right, along x, and what was drawn away from the user, along the sheet's y, is
// up. Sheets are moved so that plants stand on the desk: the base of a plant whose place on the
// paper is known lies there, that of any other plant a tenth of the tablet's depth above its lower
// edge.
struct Paper {
    Vec2 base_mm = Vec2::Zero();   // On the sheet, in tablet-centred millimetres,
    Vec3 stands_mm = Vec3::Zero(); // and where that is in the world.
    // World millimetres per millimetre of the sheet: 1, but for plants that were drawn smaller
    // since they are farther away (picture_ground.h).
    double unit = 1;

    Vec3 world_of_sheet(Vec2 const& sheet_mm) const
    {
        Vec2 const off = unit * (sheet_mm - base_mm);
        return stands_mm + Vec3(off.x(), 0, off.y());
    }

    // The place in front of which a point stands.
    Vec2 sheet_of_world(Vec3 const& world_mm) const
    {
        Vec3 const off = world_mm - stands_mm;
        return base_mm + Vec2(off.x(), off.z()) / unit;
    }
};

// The paper on which a plant was drawn. No value: on none.
std::optional<Paper> paper_of(PlantState const& plant);

// The paper on which the active plant was drawn, or would be.
Paper paper_of(DocumentState const& state);

// Puts another source in the place of a plant's that was drawn on paper, with its base there now:
// the plant stays under its ink.
void redraw_on_paper(DocumentState& state, std::size_t number, PlantSource source,
                     Vec2 const& base_mm);

} // namespace tractus::scene
