#pragma once

#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/view/view.h"

#include <cstdint>
#include <span>

namespace tractus::lsystem {

// A piece of a drawing and where it stands.
struct DrawnPiece {
    TurtleDrawing drawing;
    std::size_t parent = 0;             // The piece whose gap it fills; before it in the array.
    std::uint32_t root_segment = kNone; // There; kNone: it stands on the ground.
};

// Puts pieces together to the plant that one turtle would have drawn, in the order of the string,
// however it was cut: axes in the order in which they were begun. Piece 0 is the outermost; every
// other fills the gap of one before it. Lengths of organ shapes are in turtle units of `unit_mm`.
//
// Materials: bark first, for colours that the view does not define; then those that were used, by
// turtle colour; then those of organs that the view does not define. Organ shapes: by letter.
//
// Pieces that were drawn as planned (segment_plan.h) have no axes and segments: those are in
// `drawn`, with turtle colours as their materials.
Plant assemble_plant(View const& view, double unit_mm, std::span<DrawnPiece> pieces,
                     Plant drawn = {});

// Gives a plant without any its axes, segments and their nodes, to be written.
void make_room(Plant& plant, std::size_t axis_count, std::size_t segment_count);

} // namespace tractus::lsystem
