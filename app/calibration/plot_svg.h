#pragma once

#include "app/calibration/plot.h"

#include <span>
#include <string>

namespace tractus::calibration {

struct PlotSheet {
    std::string title {};
    std::string subtitle {};
};

// Diagrams side by side, two to a row, as an SVG picture on white. The same plots give the same
// bytes.
std::string print_svg(PlotSheet const& sheet, std::span<Plot const> plots);

} // namespace tractus::calibration
