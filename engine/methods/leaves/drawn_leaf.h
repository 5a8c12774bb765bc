#pragma once

#include "engine/methods/leaves/flat_blade.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::leaf {

// Parameters of a drawn leaf; its grammar has each of them under its own name. Lengths are shares
// of the blade's length, angles are degrees, and all are rounded as in the grammar's text.
struct DrawnLeaf {
    // A position on a main vein where side veins begin, on one side or both.
    struct Knot {
        double at = 0; // Position of the knot, as a share of the main vein's length.
        std::optional<double> right_deg {}; // Angle of the vein to the main vein's direction.
        std::optional<double> left_deg {};

        bool operator==(Knot const&) const = default;
    };
    struct Main {
        // Angle of the vein to the leaf's axis, positive to the right; 0 for the midrib.
        double angle_deg = 0;
        // Total turn of the vein from beginning to end, positive to the right.
        double curve_deg = 0;
        std::vector<Knot> knots {}; // Knots, sorted from the vein's beginning.

        bool operator==(Main const&) const = default;
    };
    using Half = std::vector<HalfOutline::Point>;

    double size_mm = 0; // Length of the blade along its midrib.
    double stalk = 0;
    Half right {}; // Right half outline, from the petiole's end at (0, 0) to the tip.
    // Left half outline, with x positive to the left; empty: mirror image of the right half.
    Half left {};
    HalfOutline::Margin margin = HalfOutline::Margin::Entire;
    int tooth_count = 0; // Number of teeth on each half.
    double tooth_depth = 0;
    double tooth_lean = 0;
    // Main veins: the midrib first, then the others from the outermost right to the outermost left
    // one.
    std::vector<Main> mains;
    double hub = 0; // Length of the segment on which the main veins begin, if there are several.
    // Curve of the side veins at the beginning of a main vein, and (side_curve_at_tip_deg) at its
    // end: the turn towards the main vein's end, negative away from it.
    double side_curve_deg = 0;
    double side_curve_at_tip_deg = 0;
    double bend_deg = 0; // Total downward bend of the midrib.
    // Difference between the bends of the midrib's upper and lower half, times two.
    double droop_deg = 0;
    double rise_deg = 0; // Upward angle of the blade on both sides of the midrib.
    // Width of the midrib at its beginning; other veins are proportional to it.
    double width = 0.014;
    double spread_deg = 2.5; // Standard deviation of vein angles between leaves.

    bool operator==(DrawnLeaf const&) const = default;
};

// Record of how a drawing was converted to parameters.
struct LeafFit {
    struct Vein {
        std::size_t stroke = 0;
        // Stroke index of the parent main vein; for a main vein its own index.
        std::size_t parent = 0;
        double drawn_at = 0; // Position of the vein's beginning, as a share of the parent's length.
        double fitted_at = 0;
        // Angle of the vein to the parent's direction, or to the leaf's axis; positive to the
        // right.
        double drawn_angle_deg = 0;
        double fitted_angle_deg = 0;
        double drawn_length_mm = 0;
        double fitted_length_mm = 0; // Length from the vein's beginning to the margin.
    };
    DrawnLeaf leaf;
    std::vector<Vein> veins {}; // Veins in the drawing's order.
    // The outline as drawn, but with a straight midrib, in units of the blade's length;
    // counter-clockwise.
    FlatLine outline {};
    double asymmetry = 0; // Difference between the halves' areas, as a share of the total area.
    double tremor_mm = 0; // Standard deviation of the drawn veins from the fitted curves.
    double sweep_deg = 0; // Sideways turn of the drawn midrib; the grammar's midrib has none.
    BladePlace place {};
};

// Determines the parameters of a recognised leaf. Fails with a user error if the outline does not
// surround the midrib.
Result<LeafFit> fit_leaf(RecognisedLeaf const& leaf);

// Intersection over union of the areas of two closed polylines.
double overlap_of(FlatLine const& a, FlatLine const& b);

// Overlap of the outline that a fitted leaf's grammar derives (derived_outline()) with the outline
// as drawn: intersection over union with LeafFit::outline, times the share of the drawn area that
// this outline still has. The share is below 1 where parts of the blade lie on no side of the
// midrib, as those below a stalk in the middle of the blade.
double overlap_with_drawing(RecognisedLeaf const& drawn, LeafFit const& fit,
                            FlatLine const& derived);

} // namespace tractus::leaf
