#pragma once

#include "app/calibration/plot.h"

#include <span>
#include <string>

namespace tractus::calibration {

struct PlotSheet {
    std::string title {};
    std::string subtitle {};
};

// Draws diagrams as an SVG image on white, two in a row. The same input gives the same bytes.
std::string print_svg(PlotSheet const& sheet, std::span<Plot const> plots);

} // namespace tractus::calibration
