#pragma once

#include "calib/height_capture.h"
#include "calib/height_model_fit.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::calib {

// How a rig came to its numbers: kept with it for whoever asks how good they are, or wants to fit
// them anew. Dates are "2026-11-21"; standard errors are named errors.

// Identity of a height sensor. Another one of the same make has another potentiometer.
struct SensorIdentity {
    std::string name {};
    std::string id {};     // "0003:1209:0001": bus, vendor, product, hexadecimal.
    std::string serial {}; // Empty if it has none.

    bool operator==(SensorIdentity const&) const = default;
};

struct HeightRecord {
    std::string date {};
    SensorIdentity sensor {};

    // Input: enough to do the fit again.
    std::vector<HeightCapture> captures {};
    double ruler_error_mm = 0.3;
    double linearity_percent = 0; // Of the track, by its data sheet; 0: taken to be straight.
    std::optional<HeightModelKind> asked_kind {};

    // Results.
    std::string reason {};
    std::vector<double> errors {};       // Errors of the model's parameters, in their order.
    std::vector<std::size_t> slipped {}; // Indices of captures.
    double rms_mm = 0; // Root mean square of the residuals, slipped captures left out …
    double max_mm = 0; // … and the greatest.
    Vec2 heights_mm = Vec2::Zero();       // The calibrated range, lowest and highest …
    Vec2 mm_per_count = Vec2::Zero();     // … and what a count is worth there.
    double noise_counts = 0;              // Noise at rest.
    std::optional<Vec2> hysteresis_mm {}; // Height from below less from above, and its error.

    // Millimetres by which re-zeroing has raised the model since the fit.
    double raised_mm = 0;

    // Counts that each height reads more since the fit, by re-zeroing after the string slipped.
    double shifted_counts = 0;
};

// Results of a TravelFit, rounded for the file.
struct TravelRecord {
    std::string date {};
    Vec2 shear_error = Vec2::Zero();
    double tilt_deg = 0;
    double tilt_error_deg = 0;
    double rise_mm = 0;
    double rms_mm = 0;
    std::size_t touches = 0;
};

// Results of a LatencyFit, rounded for the file.
struct LatencyRecord {
    std::string date {};
    double delay_ms = 0; // Tablet's less height sensor's.
    double error_ms = 0;
    double correlation = 0;
    double rms_mm = 0;
    std::size_t touches = 0;

    // The pen's place on its way up less that on its way down, along the edge, and its error.
    std::optional<Vec2> direction_mm {};
};

// Results of a TiltFit, rounded for the file.
struct TiltRecord {
    std::string date {};
    Vec2 coil_height_mm = Vec2::Zero(); // As found; the rig's is zero if that is next to nothing.
    Vec2 coil_height_error_mm = Vec2::Zero();
    Vec2 least_tilt_deg = Vec2::Zero();
    Vec2 most_tilt_deg = Vec2::Zero();
    double rms_mm = 0;
    std::size_t touches = 0;
};

// Results of a HeightCheck, rounded for the file.
struct CheckRecord {
    std::string date {};
    std::vector<double> heights_mm {}; // Heights by the ruler.
    std::vector<double> errors_mm {};  // The rig's height less the ruler's.
    double within_mm = 0;
};

struct CalibrationRecord {
    std::optional<HeightRecord> height {};
    std::optional<TravelRecord> travel {};
    std::optional<LatencyRecord> latency {};
    std::optional<TiltRecord> tilt {};
    std::optional<CheckRecord> check {};
};

} // namespace tractus::calib
