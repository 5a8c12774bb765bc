#pragma once

#include "app/calibration/plot.h"
#include "calib/height_fit.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::calibration {

// Draws four diagrams of a height calibration: the fitted model with its captures, the residuals
// with their expected bands, errors after upward against downward movement, and the scatter of
// readings at rest.
std::vector<Plot> height_plots(calib::HeightFit const& fit,
                               std::span<calib::HeightCapture const> captures,
                               std::int32_t full_scale_counts);

} // namespace tractus::calibration
