#pragma once

#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/explain_sketch.h"
#include "tests/engine/methods/construction_lines/habits.h"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace tractus::lines {

// The interpretation of a drawn sketch by one of the readers.
struct ReadSketch {
    std::vector<Role> roles; // Role of each stroke.
    LineSketch sketch;
    std::vector<std::string> reasons {}; // For each stroke that was left out: the reason.
};

// Reads the strokes one after the other. Sketches were read like this before they were read as a
// whole.
inline ReadSketch read_one_by_one(DrawnSketch const& drawn)
{
    LineRecogniser recogniser;
    ReadSketch read;
    for (auto const& stroke : drawn.strokes)
        read.roles.push_back(recogniser.add(without_repeats(capture_line(stroke.points))).role);
    read.sketch = recogniser.sketch();
    return read;
}

inline ReadSketch read_as_whole(DrawnSketch const& drawn)
{
    std::vector<StrokeToExplain> strokes;
    for (auto const& stroke : drawn.strokes)
        strokes.push_back({ .points = without_repeats(stroke.points) });
    auto const explanation = explain_sketch(strokes).front();
    ReadSketch read { .roles = {}, .sketch = explanation.sketch };
    for (auto const& stroke : explanation.strokes) {
        read.roles.push_back(stroke.role);
        read.reasons.push_back(stroke.reason);
    }
    return read;
}

// Describes what was misread; empty if the sketch was read as intended. Lengths are compared as
// shares of the stem's length, with a further tolerance of 1 mm for the inaccuracy of the hand.
inline std::string describe_misreading(DrawnSketch const& drawn, ReadSketch const& read)
{
    for (std::size_t i = 0; i < drawn.strokes.size(); ++i)
        if (read.roles[i] != drawn.strokes[i].role)
            return fmt::format("stroke {} of {} is {}, not {} {}", i, drawn.strokes.size(),
                               name_of(read.roles[i]), name_of(drawn.strokes[i].role),
                               i < read.reasons.size() ? read.reasons[i] : "");
    auto const measure = [](LineSketch sketch) {
        sketch.nodes_above.assign(std::max<std::size_t>(1, sketch.inclinations.size()), 5);
        return measure_sketch(sketch, Missing::Guessed);
    };
    auto const meant = measure(drawn.meant);
    auto const found = measure(read.sketch);
    if (!meant)
        return "generator: " + meant.error().message;
    if (!found)
        return found.error().message;
    double const height_mm = meant->stem.length_mm();
    double const slack = (1.5 + 3 * drawn.tremor_mm) / height_mm;
    if (meant->inclinations.size() != found->inclinations.size())
        return fmt::format("{} inclination lines, not {}", found->inclinations.size(),
                           meant->inclinations.size());
    for (double const x : { 0.0, 0.5, 1.0 })
        if (double const off = (meant->stem.point(x) - found->stem.point(x)).norm() / height_mm;
            off > 0.04 + slack)
            return fmt::format("the stem is {:.3f} off at {}", off, x);
    for (std::size_t i = 0; i < meant->inclinations.size(); ++i) {
        auto const& line = meant->inclinations[i];
        auto const& other = found->inclinations[i];
        if (std::fabs(line.x - other.x) > 0.03 + slack)
            return fmt::format("inclination line {} crosses at {:.3f}, not {:.3f}", i, other.x,
                               line.x);
        double const off_deg = std::max(std::fabs(line.left_deg - other.left_deg),
                                        std::fabs(line.right_deg - other.right_deg));
        if (off_deg > 8 + degrees(slack))
            return fmt::format("inclination line {} leans {:.1f} degrees otherwise", i, off_deg);
    }
    double most = 0;
    for (int i = 0; i <= 10; ++i) {
        double const low = meant->inclinations.front().x;
        double const high = meant->inclinations.back().x;
        double const x = low + (high - low) * i / 10;
        auto const a = values_at(*meant, x);
        auto const b = values_at(*found, x);
        most = std::max(
            { most, std::fabs(a.left_size - b.left_size), std::fabs(a.right_size - b.right_size) });
    }
    return most > 0.05 + 2 * slack ? fmt::format("sizes differ by {:.3f}", most) : "";
}

// Returns a sketch with the given habits, 30 to 300 mm high. The tremor of the hand is 0.05 to 0.35
// mm.
inline DrawnSketch draw_with(std::uint64_t seed, std::vector<Habit> const& habits)
{
    Hand chooser(seed * 7919 + 17);
    double const height_mm = 30 * std::pow(10, chooser.between(0, 1));
    double const tremor_mm = std::min(chooser.between(0.05, 0.35), 0.003 * height_mm);
    return HabitualIllustrator(seed, height_mm, tremor_mm, habits).draw();
}

} // namespace tractus::lines
