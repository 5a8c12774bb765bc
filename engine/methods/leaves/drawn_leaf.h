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

// A drawn leaf in numbers, each of which its grammar has by name. Lengths are shares of the
// blade's length, angles are degrees; they are rounded as their text is.
struct DrawnLeaf {
    // A place on a main vein where side veins begin, on one of its sides or on both.
    struct Knot {
        double at = 0;                      // Share of the main vein's length.
        std::optional<double> right_deg {}; // From the main vein's direction.
        std::optional<double> left_deg {};

        bool operator==(Knot const&) const = default;
    };
    struct Main {
        double angle_deg = 0;       // From the leaf's axis, positive to the right. 0: the midrib.
        double curve_deg = 0;       // Turns so far from begin to end, positive to the right.
        std::vector<Knot> knots {}; // From its begin on.

        bool operator==(Main const&) const = default;
    };
    using Half = std::vector<HalfOutline::Point>;

    double size_mm = 0; // Length of the blade along its midrib.
    double stalk = 0;
    Half right {}; // From (0, 0), the stalk's end, to the tip.
    Half left {};  // Its x to the left; empty: it mirrors the right half.
    HalfOutline::Margin margin = HalfOutline::Margin::Entire;
    int tooth_count = 0; // On each half.
    double tooth_depth = 0;
    double tooth_lean = 0;
    std::vector<Main>
        mains;      // The midrib, then the others from the outermost right one to the left.
    double hub = 0; // Length of the piece on which main veins begin, if there are several.
    // Side veins turn so far towards the main vein's end, those at its begin and those at its end;
    // negative: away from it.
    double side_curve_deg = 0;
    double side_curve_at_tip_deg = 0;
    double bend_deg = 0;     // Bend of the midrib, downwards, all in all.
    double droop_deg = 0;    // Twice what its upper half bends more than its lower one.
    double rise_deg = 0;     // How far the blade rises on both sides of the midrib.
    double width = 0.014;    // Width of the midrib at its begin; others follow.
    double spread_deg = 2.5; // Standard deviation of veins' angles from leaf to leaf.

    bool operator==(DrawnLeaf const&) const = default;
};

// How a drawing became numbers.
struct LeafFit {
    struct Vein {
        std::size_t stroke = 0;
        std::size_t parent = 0; // Stroke of the main vein that bears it; a main vein's own.
        double drawn_at = 0;    // Shares of the parent's length.
        double fitted_at = 0;
        double drawn_angle_deg
            = 0; // From the parent's direction, or the leaf's axis; to the right.
        double fitted_angle_deg = 0;
        double drawn_length_mm = 0;
        double fitted_length_mm = 0; // To the margin.
    };
    DrawnLeaf leaf;
    std::vector<Vein> veins {}; // In the drawing's order.
    // As drawn, its midrib straight, in the blade's lengths; counter-clockwise.
    FlatLine outline {};
    double asymmetry = 0; // Area that one half lacks of the other, as a share of both together.
    double tremor_mm = 0; // What the fit took out of the veins, as a standard deviation.
    double sweep_deg = 0; // How far the midrib turns sideways: the grammar's is straight.
    BladePlace place {};
};

// Finds the numbers of a recognised leaf. Fails, as the user's fault, where the outline does not
// lie round the midrib.
Result<LeafFit> fit_leaf(RecognisedLeaf const& leaf);

// The area that two closed lines have in common, as a share of the area that one of them has.
double overlap_of(FlatLine const& a, FlatLine const& b);

} // namespace tractus::leaf
