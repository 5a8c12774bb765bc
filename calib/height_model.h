#pragma once

#include <optional>
#include <variant>

namespace tractus {

// What a reading of the height sensor means in millimetres. Height is that of the tablet's carriage
// over its zero, the lowest position at which the rig was calibrated; it grows upwards, and
// readings grow with it. (A potentiometer that counts down has its two outer wires swapped.)

// A sensor along the carriage's way: a string that hangs plumb, a slide potentiometer, a
// rangefinder.
//
//     height = mm_per_count * (counts - zero_counts)
struct LinearHeight {
    double mm_per_count = 0.1; // Greater than 0.
    double zero_counts = 0;    // The reading at height zero; may lie outside the converter's range.
};

// A string potentiometer whose spool stands beside the carriage's way, so that the string runs
// aslant and a millimetre of height draws out less than a millimetre of string, least at the
// bottom.
//
//               A      A: where the string is tied to the carriage; moves straight up and down.
//              /|      S: where the string leaves the spool.
//       L     / |
//            /  |      L      = mm_per_count * counts + zero_length_mm
//           /   | h    L^2    = offset_mm^2 + h^2
//          /    |      height = h - base_mm = sqrt(L^2 - offset_mm^2) - base_mm
//         S-----+
//         offset_mm
//
// It holds while A is not below S: there height rises with L, and each length means one height.
struct StringHeight {
    double mm_per_count = 0.1; // String per count; greater than 0.
    double zero_length_mm = 0; // L at reading zero.
    double offset_mm = 0;      // 0 or more.
    double base_mm = 0;        // h at height zero; 0 or more.
};

using HeightModel = std::variant<LinearHeight, StringHeight>;

// Height for a reading, which may be a fraction (a mean of many). No value where the model does not
// hold: a string shorter than its offset, a reading that is not a number.
std::optional<double> height_mm(HeightModel const& model, double counts);

// The reading for a height: the inverse of height_mm. No value where the model does not hold.
std::optional<double> counts_at_height(HeightModel const& model, double height_mm);

} // namespace tractus
