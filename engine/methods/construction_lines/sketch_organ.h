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

// The view in which a line of a leaf is drawn (OrganViews).
enum class OrganView {
    Side,    // Boundary seen from above, from base to tip.
    Midrib,  // Midrib seen from the side.
    Section, // Section seen from the front.
};

// Colour of a drawn leaf. With Picture the leaf shows its picture or, while it has none, the colour
// of Leaf.
enum class OrganColor { Leaf, White, Yellow, Pink, Violet, Red, Brown, Picture };

// Red, green and blue of a colour, from 0 to 1. nearest_color() finds the named colour nearest to
// such values; it never returns Picture.
Vec3 rgb_of(OrganColor color);
OrganColor nearest_color(Vec3 const& rgb);

// What a layer can have in place of plain leaves: a leaf drawn in three views, or the plant of
// another sketch in the form that it had when it was chosen.
struct SketchOrgan {
    struct Line {
        OrganView view = OrganView::Side;
        SketchLine line {};
    };

    scene::ItemId id = 0;
    // Lines of the leaf: one or two sides, at most one midrib and at most one section.
    std::vector<Line> lines {};
    OrganColor color = OrganColor::Leaf;
    // The bytes of a PNG file (OrganSurface::picture), used if the colour is Picture. Shared with
    // earlier states of the document.
    std::shared_ptr<std::string const> picture {};
    // Sketch whose plant is the organ; null: the organ is a leaf.
    std::shared_ptr<PenSketch const> sketch {};
};

// Returns the leaf with one more line. A new midrib or section replaces the existing one; a new
// side replaces the nearest drawn side, if there is one in its place. Fails with a user error if
// the line is a dot, or the lines give no surface.
Result<SketchOrgan> with_organ_line(SketchOrgan organ, SketchOrgan::Line line);

// Returns the views of a leaf, with tremor removed from its lines. Left and right sides are
// distinguished by position; a single side is mirrored about the line from its base to its tip. A
// midrib must be drawn from base to tip, a section in either direction. The heights of both are
// measured from the straight line between their ends; up on the sheet is towards the leaf's upper
// side. Fails like with_organ_line().
Result<OrganViews> views_of(SketchOrgan const& organ);

// Returns the surface of a leaf and its colour. Fails like with_organ_line().
Result<OrganSurface> surface_of(SketchOrgan const& organ);

} // namespace tractus::lines
