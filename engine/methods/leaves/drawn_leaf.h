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

// Parameters of a drawn leaf; the leaf's grammar has a named variable for each of them. Lengths are
// shares of the blade's length and angles are degrees, rounded as in the grammar's text.
struct DrawnLeaf {
    // A position on a main vein where side veins begin: one on the right, one on the left, or both.
    struct Knot {
        double at = 0; // Position of the knot, as a share of the main vein's length.
        // Angle between the right side vein and the main vein's direction; no value: no such vein.
        std::optional<double> right_deg {};
        std::optional<double> left_deg {};

        bool operator==(Knot const&) const = default;
    };
    struct Main {
        // Angle between the vein and the leaf's axis, positive to the right; 0 for the midrib.
        double angle_deg = 0;
        // Total turn of the vein from beginning to end, positive to the right.
        double curve_deg = 0;
        std::vector<Knot> knots {}; // Knots, sorted from the vein's beginning.

        bool operator==(Main const&) const = default;
    };
    using Half = std::vector<HalfOutline::Point>;

    // A leaflet of a compound leaf, and the piece of the rachis that leads to it.
    struct Leaflet {
        double piece
            = 0; // Length of the piece, from the leaflet before or the petiole's beginning.
        double turn_deg = 0;  // Angle by which the piece turns from the one before, to the right.
        double angle_deg = 0; // Angle between the leaflet and the piece, positive to the right.
        double stalk = 0;     // Length of the leaflet's stalk.
        double size = 0;      // Length of the leaflet's blade.

        bool operator==(Leaflet const&) const = default;
    };

    // Length of the blade along its midrib; of a compound leaf, that of its longest leaflet.
    double size_mm = 0;
    double stalk = 0; // Length of the petiole; of a compound leaf, of the rachis' first piece.
    Half right {};    // Right half outline, from the petiole's end at (0, 0) to the tip.
    // Left half outline, with x positive to the left. If empty, it is the mirror image of the right
    // half.
    Half left {};
    HalfOutline::Margin margin = HalfOutline::Margin::Entire;
    int tooth_count = 0; // Number of teeth on each half.
    double tooth_depth = 0;
    double tooth_lean = 0;
    // Main veins: the midrib first, then the others in order, from the outermost one on the right
    // to the outermost one on the left.
    std::vector<Main> mains;
    double hub = 0; // Length of the segment on which all main veins begin, if there are several.
    // Total turn, from its own beginning to its end, of a side vein at the beginning of a main
    // vein: positive towards the main vein's end, negative away from it. side_curve_at_tip_deg is
    // that of a side vein at the main vein's end; in between it is linear.
    double side_curve_deg = 0;
    double side_curve_at_tip_deg = 0;
    double bend_deg = 0; // Total downward bend of the midrib.
    // Twice the difference between the bends of the midrib's upper and lower half.
    double droop_deg = 0;
    double rise_deg = 0; // Upward angle of the blade on both sides of the midrib.
    // Width of the midrib at its beginning; the widths of other veins are proportional to it.
    double width = 0.014;
    double spread_deg = 2.5; // Standard deviation of the angle of a vein between leaves of a plant.
    // Leaflets on both sides of a compound leaf's rachis, from its beginning; empty for a simple
    // leaf. All leaflets have the blade that the other members describe.
    std::vector<Leaflet> leaflets {};
    // The leaflet in which the rachis ends, with the last piece of the rachis; size 0: the rachis
    // ends without one.
    Leaflet end {};

    bool is_compound() const { return !leaflets.empty(); }

    bool operator==(DrawnLeaf const&) const = default;
};

// The parameters found for a drawn leaf, with a record of how well they fit the drawing.
struct LeafFit {
    struct Vein {
        std::size_t stroke = 0;
        // Stroke index of the main vein on which the vein begins; for a main vein its own index.
        std::size_t parent = 0;
        double drawn_at = 0; // Position where the vein begins, as a share of the parent's length.
        double fitted_at = 0;
        // Angle between the vein and its parent's direction or, for a main vein, the leaf's axis;
        // positive to the right.
        double drawn_angle_deg = 0;
        double fitted_angle_deg = 0;
        double drawn_length_mm = 0;
        double fitted_length_mm = 0; // Length of the vein from its beginning to the margin.
    };
    DrawnLeaf leaf;
    std::vector<Vein> veins {}; // Veins in the drawing's order.
    // The drawn outline after the midrib has been straightened, in units of the blade's length;
    // counter-clockwise.
    // Empty for a compound leaf.
    FlatLine outline {};
    // The drawn outlines of a compound leaf's leaflets, in units of the longest leaflet's length:
    // the petiole begins at (0, 0) and points to (0, 1).
    std::vector<FlatLine> leaflets {};
    // Difference between the areas of the two halves, as a share of the whole area.
    double asymmetry = 0;
    double tremor_mm = 0; // Standard deviation of the drawn veins from the fitted curves.
    // Sideways turn of the drawn midrib from base to tip; the midrib of the grammar is straight.
    double sweep_deg = 0;
    BladePlace place {};
};

// Determines the parameters of a recognised leaf. The leaflets of a compound leaf get one blade,
// the mean of all, each at its own size and angle; its veins are those of the leaflet in which most
// were drawn. Fails with a user error if an outline does not surround its midrib, or for more than
// kMaxLeaflets.
constexpr std::size_t kMaxLeaflets = 48;
Result<LeafFit> fit_leaf(RecognisedLeaf const& leaf);

// Intersection over union of the areas of two closed polylines, or of those within several.
double overlap_of(FlatLine const& a, FlatLine const& b);
double overlap_of(std::vector<FlatLine> const& a, std::vector<FlatLine> const& b);

// Overlap of the outline that a fitted leaf's grammar derives with the drawn outline: its
// intersection over union with LeafFit::outline, times the share of the drawn area that
// LeafFit::outline still covers. This share is below 1 if parts of the blade are on neither side of
// the midrib, such as those below a stalk that ends in the middle of the blade. For a compound
// leaf, that of all leaflets with LeafFit::leaflets. Fails if the leaf cannot be derived.
Result<double> overlap_with_drawing(RecognisedLeaf const& drawn, LeafFit const& fit);

} // namespace tractus::leaf
