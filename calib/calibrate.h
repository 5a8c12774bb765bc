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

// Functions for what a fit changes in a rig, and for the record that it leaves there. Numbers are
// rounded to what a reader of the rig file can take in, far below their errors. `date` is today's,
// "2026-11-21".

SensorIdentity identity_of(drivers::DeviceInfo const& info);

struct HeightCalibration {
    HeightFit fit {};
    std::vector<HeightCapture> captures {}; // Captures that the fit was made from.
    HeightFitOptions options {};
    std::int32_t full_scale_counts = 0;
    SensorIdentity sensor {};
};

Rig with_height(Rig rig, HeightCalibration const& calibration, std::string const& date);
Rig with_travel(Rig rig, TravelFit const& fit, std::string const& date);
Rig with_latency(Rig rig, LatencyFit const& fit, std::string const& date);
Rig with_tilt(Rig rig, TiltFit const& fit, std::string const& date);
Rig with_check(Rig rig, HeightCheck const& check, std::string const& date);

// The fit done again from a rig's own record, for its plots. Fails if the rig has no record, and as
// fit_height does.
Result<HeightFit> refit_height(Rig const& rig);

} // namespace tractus::calib
