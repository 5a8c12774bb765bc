#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::calib {

// Meaning of the height sensor's readings in millimetres. Height is that of the tablet's carriage
// over the rig's zero, which is where the ruler of the calibration had its own. It grows upwards;
// readings may grow or fall with it, since a potentiometer counts down when its two outer wires are
// swapped.

// A potentiometer's track is not quite even, and a converter that draws current bends its readings.
// The law is that of a straight track, which would have read `shift_counts` more where this one
// reads `counts`. Between knots the shift is a cubic Hermite whose slope at a knot is that from the
// knot before to the knot after; beyond the outer knots it stays what it is there.
struct TrackKnot {
    double counts = 0;
    double shift_counts = 0;
};

// Knots whose counts increase and whose shifts change by at most 0.3 of that, so that each height
// still has one reading; empty: a straight track.
using TrackBend = std::vector<TrackKnot>;

// The reading of a straight track.
double straightened(TrackBend const& bend, double counts);

// A sensor along the carriage's way: a string that hangs plumb, a slide potentiometer, a
// rangefinder.
//
//     height = mm_per_count * (counts - zero_counts)
struct LinearHeight {
    double mm_per_count = 0.1; // Never 0; below 0 where readings fall as the carriage rises.
    double zero_counts = 0;    // The reading at height zero; may lie outside the converter's range.
    TrackBend bend {};
};

// A string potentiometer whose spool stands beside the carriage's way, so that the string runs
// aslant and a millimetre of height draws out less than a millimetre of string, least where string
// and way are nearest to a right angle.
//
//               A      A: where the string is tied to the carriage; moves straight up and down.
//              /|      S: where the string leaves the spool.
//       L     / |
//            /  |      L      = mm_per_count * counts + zero_length_mm
//           /   | r    L^2    = offset_mm^2 + r^2
//          /    |      height = r - base_mm = sqrt(L^2 - offset_mm^2) - base_mm
//         S-----+
//         offset_mm
//
// It holds while A is not below S: there height rises with L, and each length means one height.
// With the spool above the carriage's way everything is upside down: A hangs r below S, and
//
//     height = -r - base_mm
//
// The converter measures the wiper's voltage in parts of the potentiometer's own supply, so
// mm_per_count times the converter's full scale is the string that the whole potentiometer takes
// up, whatever the supply is.
struct StringHeight {
    enum class Spool {
        Below, // Readings of string length grow as the carriage rises.
        Above,
    };

    double mm_per_count = 0.1; // String per count; not 0, below 0 where readings fall with length.
    double zero_length_mm = 0; // L at reading zero.
    double offset_mm = 0;      // 0 or more.
    double base_mm = 0;        // r at height zero; its negative where the spool is above.
    Spool spool = Spool::Below;
    TrackBend bend {};
};

// A sensor that follows no simple law, such as a worn or a hand-wound potentiometer: a smooth curve
// through knots that rises or falls all the way, as the knots do. Between the knots it is the
// monotone piecewise cubic Hermite interpolant of F. N. Fritsch and J. Butland, "A method for
// constructing local monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5, 1984;
// beyond them it goes on straight.
struct MonotoneHeight {
    struct Knot {
        double counts = 0;
        double height_mm = 0;
    };
    // At least two knots; counts increase, heights increase or decrease throughout.
    std::vector<Knot> knots;
};

using HeightModel = std::variant<LinearHeight, StringHeight, MonotoneHeight>;

// "linear", "string" or "monotone": the words of the rig file and of the command line.
std::string_view name_of(HeightModel const& model);

// Whether a model's numbers are such as its comments ask for.
bool is_valid(HeightModel const& model);

// Height for a reading, which may be a fraction (a mean of many). No value where the model does not
// hold: a string shorter than its offset, a reading that is not a number.
std::optional<double> height_mm(HeightModel const& model, double counts);

// The reading for a height: the inverse of height_mm. No value where the model does not hold.
std::optional<double> counts_at_height(HeightModel const& model, double height_mm);

// Millimetres of height per count at a reading: what one step of the converter is worth there. Its
// sign says whether readings grow or fall as the carriage rises. No value as for height_mm.
std::optional<double> mm_per_count_at(HeightModel const& model, double counts);

// Returns the model for a zero that is `rise_mm` lower: each reading means so much more height.
HeightModel raised(HeightModel model, double rise_mm);

// Returns the model for a string that has slipped on its spool: each height now reads
// `shift_counts` more.
HeightModel shifted(HeightModel model, double shift_counts);

// A model's numbers as a fit sees them, in the order of its members (a monotone model's are the
// heights of its knots), and the model of the same kind with other numbers. A track's bend is not
// among them and stays as it is.
Eigen::VectorXd parameters_of(HeightModel const& model);
HeightModel with_parameters(HeightModel model, Eigen::VectorXd const& parameters);

// The bend of a model's track, empty where it has none, and the model with another one; a monotone
// model has none.
TrackBend const& bend_of(HeightModel const& model);
HeightModel with_bend(HeightModel model, TrackBend bend);

} // namespace tractus::calib
