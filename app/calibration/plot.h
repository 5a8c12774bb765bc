#pragma once

#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::calibration {

// Data of diagrams, drawn as SVG beside the rig file (plot_svg.h) and in the window.

// Subject of a series; each renderer has its own colours for them.
enum class PlotTone {
    Model,     // The fitted model.
    FromBelow, // Captures after the carriage moved up.
    FromAbove,
    FromNowhere,
    Slipped,  // Captures that were left out.
    Expected, // Errors expected of a good fit.
    Measured, // Errors actually measured.
};

struct PlotSeries {
    enum class Kind {
        Line,
        Dots,
        Crosses,
        Bars, // Bars from zero to y, `bar_width` wide.
        Band, // A band between `points` and `upper`.
    };

    Kind kind = Kind::Line;
    PlotTone tone = PlotTone::Model;
    std::string label {}; // Text in the legend; empty: not listed.
    std::vector<Vec2> points {};
    std::vector<Vec2> upper {};
    double bar_width = 0;
};

struct Plot {
    std::string title {};
    std::string x_label {}; // Label of the x axis, including the unit.
    std::string y_label {};
    Vec2 low = Vec2::Zero();           // Lower left corner of the visible range.
    Vec2 high = Vec2::Ones();          // Upper right corner of the visible range.
    std::vector<PlotSeries> series {}; // The series in drawing order, the bottom one first.
};

// Sets low and high so that everything is visible, with a margin.
enum class PlotRange {
    Tight,
    SymmetricY, // The range is symmetric about zero.
    FromZeroY,
};
void fit_range(Plot& plot, PlotRange range);

// About `count` round numbers between two values.
std::vector<double> ticks_between(double low, double high, int count);

// Formats a tick's number, without rounding noise in its last digits.
std::string tick_text(double value);

} // namespace tractus::calibration
