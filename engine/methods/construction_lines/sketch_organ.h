#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/organ_surface.h"
#include "engine/methods/construction_lines/sketch_line.h"
#include "engine/scene/anchored.h"

#include <memory>
#include <string>
#include <vector>

namespace tractus::lines {

struct PenSketch;

// What a line of a leaf shows (OrganViews).
enum class OrganView {
    Side,    // From above: one of its two boundaries, from base to tip.
    Midrib,  // From the side.
    Section, // From the front.
};

// What colour a drawn leaf has. Picture: that of its picture, and as Leaf until it has one.
enum class OrganColor { Leaf, White, Yellow, Pink, Violet, Red, Brown, Picture };

// Red, green and blue from 0 to 1, and of such a colour the nearest one, never Picture.
Vec3 rgb_of(OrganColor color);
OrganColor nearest_color(Vec3 const& rgb);

// What may stand in the place of plain leaves: a leaf as a pen drew it in three views, or the plant
// of another sketch as it was when it was chosen.
struct SketchOrgan {
    struct Line {
        OrganView view = OrganView::Side;
        SketchLine line {};
    };

    scene::ItemId id = 0;
    std::vector<Line> lines {}; // One or two sides, at most one midrib and one section.
    OrganColor color = OrganColor::Leaf;
    // OrganSurface::picture, which counts where the color is Picture. Shared with earlier states.
    std::shared_ptr<std::string const> picture {};
    std::shared_ptr<PenSketch const> sketch {}; // Not null: it is this one's plant.
};

// The leaf with one more line. A side takes the place of that beside which it is, and so does
// another midrib or section. Fails, as the user's fault, for a dot, and where the lines give no
// surface.
Result<SketchOrgan> with_organ_line(SketchOrgan organ, SketchOrgan::Line line);

// The views of a leaf as its lines show them, after the hand's tremor is taken out: which side is
// the left one is seen from how they lie, and one alone is mirrored at the way from its base to its
// tip. A midrib is drawn from base to tip, a section in either direction; up on the sheet is the
// upper side of both, however steep they lie. Fails like with_organ_line().
Result<OrganViews> views_of(SketchOrgan const& organ);

// The surface of a leaf, and its colour. Fails like with_organ_line().
Result<OrganSurface> surface_of(SketchOrgan const& organ);

} // namespace tractus::lines
