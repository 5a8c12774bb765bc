#include "engine/methods/construction_lines/sketch_line.h"

#include "engine/methods/construction_lines/capture_line.h"
#include "engine/methods/construction_lines/hand_line.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/upright_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tractus::lines {

// Sets the depth of a stem's points by the pen's pressure.
static void press(std::vector<Vec3>& places, std::vector<TipSample> const& tips)
{
    // Change in depth for the whole range of pressure, as a share of the stem's length.
    constexpr double kDepth = 0.5;
    constexpr double kWindow = 0.05;
    // Number of steps along the stem at which the moving average of the pressure is computed.
    constexpr int kSteps = 100;
    std::vector<double> at { 0 };
    for (std::size_t i = 1; i < places.size(); ++i)
        at.push_back(at.back() + (places[i] - places[i - 1]).head<2>().norm());
    double const length_mm = at.back();
    if (!(length_mm > 0))
        return;
    std::vector<double> pressures;
    for (int step = 0; step <= kSteps; ++step) {
        double const middle = std::clamp(static_cast<double>(step) / kSteps, kWindow, 1 - kWindow);
        double sum = 0;
        double weights = 0;
        for (std::size_t i = 0; i < tips.size(); ++i) {
            double const off = std::fabs(at[i] / length_mm - middle) / kWindow;
            double const weight = std::max(1e-9, 1 - off);
            sum += weight * tips[i].pressure;
            weights += weight;
        }
        pressures.push_back(sum / weights);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        double const step = std::min(at[i] / length_mm, 1.0) * kSteps;
        auto const low = std::min(static_cast<std::size_t>(step), pressures.size() - 2);
        double const pressure
            = std::lerp(pressures[low], pressures[low + 1], step - static_cast<double>(low));
        places[i].z() = kDepth * length_mm * (pressure - pressures.front());
    }
}

Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line)
{
    auto const dot
        = [] { return fail(Fault::User, "this is only a dot: draw a line of the sketch"); };
    auto const tips = TRY(line.stroke.tips.in_memory());
    bool const is_flat
        = !line.level_mm && resolve_surface(tips, StrokeSurface::Decided) == StrokeSurface::Paper;
    double const lift_mm
        = line.level_mm && !tips.empty() ? tips.front().position_mm.z() - *line.level_mm : 0;
    std::vector<Vec3> places;
    for (auto const& tip_mm : plant_tips(tips, StrokeSurface::Paper)) {
        auto const place_mm = line.sheet.on_sheet({ tip_mm.x(), tip_mm.z() });
        places.emplace_back(place_mm.x(), place_mm.y(),
                            is_flat ? 0 : line.sheet.size * (lift_mm - tip_mm.y()));
    }
    if (line.role == Role::Stem && line.depth_by == DepthBy::Pressure)
        press(places, tips.vector());
    auto const drawn = distinct_points(without_repeats(places));
    if (!drawn)
        return dot();
    bool const is_together = line.reading == Reading::Together;
    auto points = without_repeats(is_together && is_drawn_by_hand(*drawn) ? clean_hand_line(*drawn)
                                                                          : capture_line(*drawn));
    if (points.size() < 2)
        return dot();
    if (line.turn_round && !is_together)
        std::reverse(points.begin(), points.end());
    return points;
}

} // namespace tractus::lines
