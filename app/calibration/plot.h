#pragma once

#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::calibration {

// Diagrams as values: drawn as SVG beside the rig file (plot_svg.h) and in the window.

// Subject of a series; each drawing has its own colours for them.
enum class PlotTone {
    Model,     // The fit.
    FromBelow, // Captures, by where the carriage came from …
    FromAbove,
    FromNowhere,
    Slipped,  // … and those that were left out.
    Expected, // Errors as they should be.
    Measured, // Errors as they are.
};

struct PlotSeries {
    enum class Kind {
        Line,
        Dots,
        Crosses,
        Bars, // Bars from zero to y, `bar_width` wide.
        Band, // A band between points and upper.
    };

    Kind kind = Kind::Line;
    PlotTone tone = PlotTone::Model;
    std::string label {}; // Label for the legend; empty: not in it.
    std::vector<Vec2> points {};
    std::vector<Vec2> upper {};
    double bar_width = 0;
};

struct Plot {
    std::string title {};
    std::string x_label {}; // Label with the unit.
    std::string y_label {};
    Vec2 low = Vec2::Zero();           // The corner of what is shown …
    Vec2 high = Vec2::Ones();          // … and the opposite one, greater in both.
    std::vector<PlotSeries> series {}; // The first lies below.
};

// Sets low and high so that everything shows, with a margin, and zero in the middle if asked for.
enum class PlotRange {
    Tight,
    SymmetricY, // The range goes as far below zero as above.
    FromZeroY,
};
void fit_range(Plot& plot, PlotRange range);

// Round numbers between two, about `count` of them.
std::vector<double> ticks_between(double low, double high, int count);

// A tick's number as it is written, without noise in its last digits.
std::string tick_text(double value);

} // namespace tractus::calibration
