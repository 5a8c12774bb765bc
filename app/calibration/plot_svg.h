#pragma once

#include "app/calibration/plot.h"

#include <span>
#include <string>

namespace tractus::calibration {

struct PlotSheet {
    std::string title {};
    std::string subtitle {};
};

// Draws diagrams two to a row, as an SVG image on white. Deterministic to the byte.
std::string print_svg(PlotSheet const& sheet, std::span<Plot const> plots);

} // namespace tractus::calibration
