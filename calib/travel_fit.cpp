#include "calib/travel_fit.h"

#include "calib/pen_track.h"
#include "calib/plane_lines.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <vector>

namespace tractus::calib {

namespace {

constexpr std::size_t kMinTravelTouches = 100;
constexpr double kMinTravelRise_mm = 100;
constexpr double kMaxStray_mm = 3;

struct Touch {
    Vec2 position_mm = Vec2::Zero();
    double height_mm = 0;
    int stretch = 0;
};

std::vector<Touch> touches_with_height(std::span<drivers::PenSample const> pens,
                                       std::span<drivers::HeightSample const> heights,
                                       Rig const& rig)
{
    auto const track = height_track(heights, rig);
    std::vector<Touch> touches;
    for (auto const& point : touch_points(pens, rig))
        if (auto const height = height_between(track, point.time))
            touches.push_back({ point.position_mm, *height, stretch_of(point.time) });
    return touches;
}

// Returns the touches with negated heights, because a pen that seems to drift over the tablet
// stands still while the tablet drifts under it.
std::vector<PlaneSighting> sightings_of(std::vector<Touch> const& touches)
{
    std::vector<PlaneSighting> sightings;
    for (auto const& touch : touches)
        sightings.push_back({ .position_mm = touch.position_mm,
                              .against = Vec2::Constant(-touch.height_mm),
                              .stretch = touch.stretch });
    return sightings;
}

Result<double> check_rise(std::vector<Touch> const& touches)
{
    if (touches.size() < kMinTravelTouches)
        return fail(Fault::User,
                    fmt::format("the pen touched in only {} reports with a height, expected at "
                                "least {}: hold it on the tablet and against the edge while the "
                                "surface moves",
                                touches.size(), kMinTravelTouches));
    auto const [low, high]
        = std::minmax_element(touches.begin(), touches.end(), [](auto const& a, auto const& b) {
              return a.height_mm < b.height_mm;
          });
    double const rise_mm = high->height_mm - low->height_mm;
    if (rise_mm < kMinTravelRise_mm)
        return fail(Fault::User,
                    fmt::format("the surface moved by only {:.0f} mm while the pen touched, "
                                "expected at least {}: move it over most of its travel",
                                rise_mm, kMinTravelRise_mm));
    return rise_mm;
}

} // namespace

Result<TravelFit> fit_travel(std::span<drivers::PenSample const> pens,
                             std::span<drivers::HeightSample const> heights, Rig const& rig)
{
    auto const touches = touches_with_height(pens, heights, rig);
    TravelFit result { .rise_mm = TRY(check_rise(touches)), .touches = touches.size() };
    auto const lines = fit_plane_lines(sightings_of(touches));
    result.rms_mm = lines.rms_mm;
    if (result.rms_mm > kMaxStray_mm)
        return fail(Fault::User,
                    fmt::format("the pen strayed {:.1f} mm from a straight line, expected at most "
                                "{}: keep it against the edge all the time, and the edge fixed",
                                result.rms_mm, kMaxStray_mm));
    result.shear = lines.slope;
    result.shear_error = lines.slope_error;
    double const slope = result.shear.norm();
    double const slope_error = slope > 0
        ? result.shear.cwiseProduct(result.shear_error).norm() / slope
        : result.shear_error.norm();
    result.tilt_rad = std::atan(slope);
    result.tilt_error_rad = slope_error / (1 + slope * slope);
    return result;
}

} // namespace tractus::calib
