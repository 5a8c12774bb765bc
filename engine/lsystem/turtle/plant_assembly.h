#pragma once

#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/view/view.h"

#include <cstdint>
#include <span>

namespace tractus::lsystem {

// A piece of a drawing and the place at which it is attached.
struct DrawnPiece {
    TurtleDrawing drawing;
    // Index of the piece whose gap this piece fills; smaller than this piece's own index.
    std::size_t parent = 0;
    // Segment of the parent piece to which this piece is attached; kNone if it stands on the
    // ground.
    std::uint32_t root_segment = kNone;
};

// Assembles pieces to the plant that a single turtle would have drawn. The result does not depend
// on how the string was divided into pieces: axes are in the order in which they begin. Piece 0 is
// the outermost; each other piece fills a gap of an earlier one. Lengths of organ shapes are
// converted from turtle units of `unit_mm`.
//
// The plant's materials are, in this order: bark, for colours that the view does not define; the
// used materials of the view, by turtle colour; materials of organs that the view does not define.
// Organ shapes are in the order of their letters.
//
// Planned pieces (segment_plan.h) have no axes and segments of their own. These are already in
// `drawn`, with turtle colours in place of materials.
Plant assemble_plant(View const& view, double unit_mm, std::span<DrawnPiece> pieces,
                     Plant drawn = {});

// Allocates the arrays of axes, segments and nodes of a plant that has none yet.
void make_room(Plant& plant, std::size_t axis_count, std::size_t segment_count);

} // namespace tractus::lsystem
