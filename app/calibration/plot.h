#pragma once

#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::calibration {

// Data of diagrams. The diagrams are drawn as SVG beside the rig file (plot_svg.h) and in the
// window.

// What a series shows. Each renderer has its own colour for each tone.
enum class PlotTone {
    Model,     // The fitted model.
    FromBelow, // Captures after the surface moved up.
    FromAbove,
    FromNowhere,
    Slipped,  // Captures that the fit left out.
    Expected, // Range of errors expected of a good fit.
    Measured, // Errors that were measured.
};

struct PlotSeries {
    enum class Kind {
        Line,
        Dots,
        Crosses,
        Bars, // Bars from zero to the points' y, `bar_width` wide.
        Band, // A filled band between `points` and `upper`.
    };

    Kind kind = Kind::Line;
    PlotTone tone = PlotTone::Model;
    std::string label {}; // Text in the legend; empty: the series is not in the legend.
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

// How fit_range() chooses the visible range: everything is visible, with a margin.
enum class PlotRange {
    Tight,
    SymmetricY, // As Tight, but symmetric about y = 0.
    FromZeroY,
};
void fit_range(Plot& plot, PlotRange range);

// Returns about `count` round numbers between two values, for the ticks of an axis.
std::vector<double> ticks_between(double low, double high, int count);

// Formats the value of a tick, without rounding noise in the last digits.
std::string tick_text(double value);

} // namespace tractus::calibration
