#pragma once

#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/view/view.h"

#include <cstdint>
#include <span>

namespace tractus::lsystem {

// A piece of a drawing and where it is attached.
struct DrawnPiece {
    TurtleDrawing drawing;
    // Index of the piece whose gap this one fills; smaller than the index of this piece.
    std::size_t parent = 0;
    // Segment of the parent piece to which the piece is attached; kNone: the piece stands on the
    // ground.
    std::uint32_t root_segment = kNone;
};

// Assembles pieces to the plant that a single turtle would have drawn. The result does not depend
// on how the string was divided: axes are in the order in which they begin. Piece 0 is the
// outermost; each other piece fills a gap of an earlier one. Lengths of organ shapes are in turtle
// units of `unit_mm`.
//
// Materials, in this order: bark, for colours that the view does not define; the materials that
// were used, by turtle colour; materials of organs that the view does not define. Organ shapes are
// in the order of their letters.
//
// Planned pieces (segment_plan.h) have no axes and segments of their own: these are in `drawn`,
// with turtle colours in place of materials.
Plant assemble_plant(View const& view, double unit_mm, std::span<DrawnPiece> pieces,
                     Plant drawn = {});

// Allocates axes, segments and nodes in a plant that has none.
void make_room(Plant& plant, std::size_t axis_count, std::size_t segment_count);

} // namespace tractus::lsystem
