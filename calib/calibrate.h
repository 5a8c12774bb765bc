#pragma once

#include "calib/height_check.h"
#include "calib/height_fit.h"
#include "calib/latency_fit.h"
#include "calib/rig.h"
#include "calib/tilt_fit.h"
#include "calib/travel_fit.h"
#include "drivers/reports/device_info.h"

#include <cstdint>
#include <span>
#include <string>

namespace tractus::calib {

// Functions that apply the result of a fit to a rig and record it there. Numbers are rounded so
// that the rig file is easy to read, but far more finely than their errors. `date` is today's date,
// in the form "2026-11-21".

SensorIdentity identity_of(drivers::DeviceInfo const& info);

struct HeightCalibration {
    HeightFit fit {};
    std::vector<HeightCapture> captures {}; // Captures used for the fit.
    HeightFitOptions options {};
    std::int32_t full_scale_counts = 0;
    SensorIdentity sensor {};
};

Rig with_height(Rig rig, HeightCalibration const& calibration, std::string const& date);
Rig with_travel(Rig rig, TravelFit const& fit, std::string const& date);
Rig with_latency(Rig rig, LatencyFit const& fit, std::string const& date);
Rig with_tilt(Rig rig, TiltFit const& fit, std::string const& date);
Rig with_check(Rig rig, HeightCheck const& check, std::string const& date);

// Repeats the height fit from the rig's record, for plots. Fails if the rig has no height record,
// or as fit_height() does.
Result<HeightFit> refit_height(Rig const& rig);

} // namespace tractus::calib
