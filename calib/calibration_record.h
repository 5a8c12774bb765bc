#pragma once

#include "calib/height_capture.h"
#include "calib/height_model_fit.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::calib {

// The origin of a rig's numbers, kept with the rig so that their accuracy can be judged and the fit
// repeated. Dates are "2026-11-21"; `error` or `errors` in a name means standard error, unless
// described otherwise.

// Identity of a height sensor, since another sensor of the same model has another potentiometer.
struct SensorIdentity {
    std::string name {};
    std::string id {};     // Bus, vendor and product id, hexadecimal: "0003:1209:0001".
    std::string serial {}; // Empty if the sensor has none.

    bool operator==(SensorIdentity const&) const = default;
};

struct HeightRecord {
    std::string date {};
    SensorIdentity sensor {};

    // Input of the fit, sufficient to repeat it.
    std::vector<HeightCapture> captures {};
    double ruler_error_mm = 0.3;
    // Linearity of the potentiometer's track in percent, from its data sheet; 0: the track is taken
    // to be straight.
    double linearity_percent = 0;
    std::optional<HeightModelKind> requested_kind {};

    // Results of the fit.
    std::string reason {};
    std::vector<double> errors {}; // Standard errors of the model's parameters, in their order.
    std::vector<std::size_t> slipped {}; // Indices of captures that were left out as slipped.
    double rms_mm = 0;              // Root mean square of the residuals, without slipped captures.
    double max_mm = 0;              // Greatest absolute residual, without slipped captures.
    Vec2 heights_mm = Vec2::Zero(); // Lowest and highest height of the calibrated range.
    Vec2 mm_per_count = Vec2::Zero(); // Height per count at the lowest and at the highest height.
    double noise_counts = 0;          // Standard deviation of a resting sensor's readings.
    // Height by the model when the carriage comes from below minus that when it comes from above,
    // and the standard error of this difference.
    std::optional<Vec2> hysteresis_mm {};

    // Millimetres by which re-zeroing has raised the model since the fit.
    double raised_mm = 0;

    // Counts by which re-zeroing after a slip of the string has shifted the readings since the fit.
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
    double delay_ms = 0; // Latency of the tablet minus that of the height sensor.
    double error_ms = 0;
    double correlation = 0;
    double rms_mm = 0;
    std::size_t touches = 0;

    // Pen position along the edge on the carriage's way up minus that on its way down, and the
    // standard error of this difference.
    std::optional<Vec2> direction_mm {};
};

// Results of a TiltFit, rounded for the file.
struct TiltRecord {
    std::string date {};
    // Fitted values; the rig's own coil height is zero if these are negligible.
    Vec2 coil_height_mm = Vec2::Zero();
    Vec2 coil_height_error_mm = Vec2::Zero();
    Vec2 min_tilt_deg = Vec2::Zero();
    Vec2 most_tilt_deg = Vec2::Zero();
    double rms_mm = 0;
    std::size_t touches = 0;
};

// Results of a HeightCheck, rounded for the file.
struct CheckRecord {
    std::string date {};
    std::vector<double> heights_mm {}; // Heights measured with the ruler.
    std::vector<double> errors_mm {};  // Height by the rig minus height by the ruler.
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
