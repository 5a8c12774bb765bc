#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/document_state.h"

#include <optional>

namespace tractus::scene {

// The tablet as a sheet of paper that stands upright in the drawing volume: right on the sheet is
// right in the world (+x), and away from the user on the sheet (+y) is up. The sheet is placed so
// that plants stand on the desk: the base of a plant coincides with its position on the paper. For
// a plant that was not drawn on paper, that position is one tenth of the tablet's depth above the
// sheet's lower edge.
struct Paper {
    // Position of the plant's base on the sheet, in millimetres from the tablet's centre.
    Vec2 base_mm = Vec2::Zero();
    Vec3 world_point_mm = Vec3::Zero(); // Position of the plant's base, world frame.
    // World millimetres per millimetre of the sheet: 1, except for plants that were drawn smaller
    // because they are farther away (picture_ground.h).
    double unit = 1;

    Vec3 world_of_sheet(Vec2 const& sheet_mm) const
    {
        Vec2 const off = unit * (sheet_mm - base_mm);
        return world_point_mm + Vec3(off.x(), 0, off.y());
    }

    // Projects a point onto the sheet, along y.
    Vec2 sheet_of_world(Vec3 const& world_mm) const
    {
        Vec3 const off = world_mm - world_point_mm;
        return base_mm + Vec2(off.x(), off.z()) / unit;
    }
};

// Returns the paper on which a plant was drawn, or no value if it was not drawn on paper.
std::optional<Paper> paper_of(PlantState const& plant);

// Returns the paper on which the active plant was drawn, or on which it would be drawn.
Paper paper_of(DocumentState const& state);

// Replaces the source of a plant that was drawn on paper. `base_mm` is the new position of the
// plant's base on the sheet. The plant moves so that it stays aligned with the ink of its drawing.
void redraw_on_paper(DocumentState& state, std::size_t number, PlantSource source,
                     Vec2 const& base_mm);

} // namespace tractus::scene
