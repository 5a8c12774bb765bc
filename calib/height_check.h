#pragma once

#include "calib/height_capture.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <span>
#include <string>
#include <vector>

namespace tractus::calib {

// How well a rig measures, from captures at heights that were not used to calibrate it.
struct HeightCheck {
    std::vector<double> heights_mm {}; // Heights by the ruler, in the captures' order …
    std::vector<double> errors_mm {};  // … and the rig's height less the ruler's.
    double within_mm = 0;              // The greatest error, rounded up to a tenth.
    double low_mm = 0;                 // The ruler's lowest and highest.
    double high_mm = 0;

    // Heights among them that the rig's own fit used or that lie outside its range: they prove
    // less, or something else.
    std::vector<double> known_mm {};
    std::vector<double> outside_mm {};
};

// Fails, as the user's fault, for no capture at all, another converter than the rig's, and readings
// that the rig's model has no height for.
Result<HeightCheck> check_height(std::span<HeightCapture const> captures,
                                 std::int32_t full_scale_counts, Rig const& rig);

// Quotes a check as a person would: "within 0.6 mm over 60–380 mm".
std::string quote(HeightCheck const& check);

// Fails, as the user's fault, if a height sensor has another converter than the rig's.
Result<void> check_converter(std::int32_t full_scale_counts, Rig const& rig);

// The height of a reading by the rig's model. Fails, as the user's fault, if it has none there.
Result<double> height_of(HeightCapture const& capture, Rig const& rig);

} // namespace tractus::calib
