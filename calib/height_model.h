#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::calib {

// Conversion of the height sensor's readings into millimetres. Height is that of the tablet's
// carriage above the rig's zero, which was the zero of the ruler during calibration. It increases
// upwards; readings may rise or fall with it, since a potentiometer counts down if its two outer
// wires are swapped.

// A knot of a track's bend: a potentiometer's track is not perfectly linear, and a converter that
// draws current bends its readings. The law refers to a straight track, which would read
// `shift_counts` more where this one reads `counts`. Between knots the shift is a cubic Hermite
// curve whose slope at a knot is that from the previous to the next knot; beyond the outer knots
// the shift is constant.
struct TrackKnot {
    double counts = 0;
    double shift_counts = 0;
};

// Knots with increasing counts, whose shifts change by at most 0.3 times the change of counts, so
// that each height has one reading. Empty: a straight track.
using TrackBend = std::vector<TrackKnot>;

// Returns the count that a straight track would read where the bent one reads `counts`.
double straightened(TrackBend const& bend, double counts);

// A sensor along the carriage's path: a vertical string, a slide potentiometer, a rangefinder.
//
//   height = mm_per_count * (counts - zero_counts)
struct LinearHeight {
    double mm_per_count = 0.1; // Never 0; negative if readings fall as the carriage rises.
    double zero_counts = 0;    // Reading at height zero; may lie outside the converter's range.
    TrackBend bend {};
};

// A string potentiometer whose spool stands beside the carriage's path, so that the string runs at
// an angle, and a millimetre of height draws out less than a millimetre of string. The closer the
// angle of string and path is to 90 degrees, the less string is drawn out.
//
//               A      A: the string's end on the carriage; moves straight up and down.
//              /|      S: the point where the string leaves the spool.
//       L     / |
//            /  |      L      = mm_per_count * counts + zero_length_mm
//           /   | r    L^2    = offset_mm^2 + r^2
//          /    |      height = r - base_mm = sqrt(L^2 - offset_mm^2) - base_mm
//         S-----+
//         offset_mm
//
// The model is valid while A is not below S: there height rises with L, and each length means one
// height. With the spool above the carriage's path everything is upside down: A hangs r below S,
// and
//
//     height = -r - base_mm
//
// The converter measures the wiper's voltage relative to the potentiometer's supply, so
// mm_per_count times the converter's full scale is the string length of the whole potentiometer,
// regardless of the supply.
struct StringHeight {
    enum class Spool {
        Below, // The string gets longer as the carriage rises.
        Above,
    };

    // String length per count; not 0, negative if readings fall with the length.
    double mm_per_count = 0.1;
    double zero_length_mm = 0; // String length L at reading 0.
    double offset_mm = 0;      // Horizontal distance of the spool; 0 or more.
    // Height r of the string's end when the carriage is at height zero; -r if the spool is above.
    double base_mm = 0;
    Spool spool = Spool::Below;
    TrackBend bend {};
};

// A sensor that follows no simple law, such as a worn or hand-wound potentiometer: a smooth curve
// through knots that rises or falls throughout, as the knots do. Between the knots it is the
// monotone piecewise cubic Hermite interpolant of F. N. Fritsch and J. Butland, "A method for
// constructing local monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5, 1984;
// beyond them it continues straight.
struct MonotoneHeight {
    struct Knot {
        double counts = 0;
        double height_mm = 0;
    };
    // At least two knots; counts increase, and heights increase or decrease throughout.
    std::vector<Knot> knots;
};

using HeightModel = std::variant<LinearHeight, StringHeight, MonotoneHeight>;

// Returns "linear", "string" or "monotone", the words of the rig file and of the command line.
std::string_view name_of(HeightModel const& model);

// True if a model's numbers satisfy the conditions in its comments.
bool is_valid(HeightModel const& model);

// Returns the height for a reading, which may be fractional (a mean). No value outside the model: a
// string shorter than its offset, a reading that is not a number.
std::optional<double> height_mm(HeightModel const& model, double counts);

// Returns the reading for a height, the inverse of height_mm(). No value outside the model.
std::optional<double> counts_at_height(HeightModel const& model, double height_mm);

// Returns millimetres of height per count at a reading. The sign shows whether readings rise or
// fall as the carriage rises. No value as for height_mm().
std::optional<double> mm_per_count_at(HeightModel const& model, double counts);

// Returns the model for a zero that is `rise_mm` lower: each reading means that much more height.
HeightModel raised(HeightModel model, double rise_mm);

// Returns the model for a string that has slipped on its spool: each height now reads
// `shift_counts` more.
HeightModel shifted(HeightModel model, double shift_counts);

// parameters_of() returns the parameters that a fit changes, in the order of the model's members
// (for a monotone model, the heights of its knots). with_parameters() returns the model with other
// values for them. The track's bend is not included and stays unchanged.
Eigen::VectorXd parameters_of(HeightModel const& model);
HeightModel with_parameters(HeightModel model, Eigen::VectorXd const& parameters);

// bend_of() returns the bend of a model's track, empty if it has none; with_bend() returns the
// model with another bend. A monotone model has no bend.
TrackBend const& bend_of(HeightModel const& model);
HeightModel with_bend(HeightModel model, TrackBend bend);

} // namespace tractus::calib
