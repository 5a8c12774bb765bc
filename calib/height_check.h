#pragma once

#include "calib/height_capture.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <span>
#include <string>
#include <vector>

namespace tractus::calib {

// Accuracy of a rig, measured with captures that were not used to calibrate it.
struct HeightCheck {
    std::vector<double> heights_mm {}; // Heights by the ruler, in the captures' order.
    std::vector<double> errors_mm {};  // Height by the rig minus height by the ruler.
    double within_mm = 0; // Greatest absolute error, rounded up to a tenth of a millimetre.
    double low_mm = 0;    // Lowest and highest height by the ruler.
    double high_mm = 0;

    // Checked heights at which the rig was also calibrated, and checked heights outside its
    // calibrated range. An error at these heights proves less about the rig's accuracy than
    // elsewhere.
    std::vector<double> known_mm {};
    std::vector<double> outside_mm {};
};

// Compares the heights by the rig's model with the heights by the ruler. Fails with a user error
// for no captures, for another converter than the rig's, and for readings outside the rig's model.
Result<HeightCheck> check_height(std::span<HeightCapture const> captures,
                                 std::int32_t full_scale_counts, Rig const& rig);

// Prints a check's result: "within 0.6 mm over 60–380 mm".
std::string quote(HeightCheck const& check);

// Fails with a user error if a height sensor has another full scale than the rig's.
Result<void> check_converter(std::int32_t full_scale_counts, Rig const& rig);

// Returns the height of a capture's reading by the rig's model. Fails with a user error if the
// model has no height at that reading.
Result<double> height_of(HeightCapture const& capture, Rig const& rig);

} // namespace tractus::calib
