#include "calib/travel_fit.h"

#include "calib/least_squares.h"
#include "calib/pen_track.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <vector>

namespace tractus {

namespace {

constexpr std::size_t kLeastTravelTouches = 100;
constexpr double kLeastTravelRise_mm = 100;
constexpr double kMostStray_mm = 3;
constexpr double kHuberDeviations = 1.345; // 95 % efficient where nothing slips.

struct Touch {
    Vec2 position_mm = Vec2::Zero();
    double height_mm = 0;
    int stretch = 0;
    double weight = 1;
};

std::vector<Touch> touches_with_height(std::span<PenSample const> pens,
                                       std::span<HeightSample const> heights, Rig const& rig)
{
    auto const track = height_track(heights, rig);
    std::vector<Touch> touches;
    for (auto const& point : touch_points(pens, rig))
        if (auto const height = height_between(track, point.time))
            touches.push_back({ point.position_mm, *height, stretch_of(point.time) });
    return touches;
}

// Weighted least squares for x (axis 0) or y: position = place - shear * (height - mean height).
LeastSquares fit_axis(std::vector<Touch> const& touches, int axis, double mean_height_mm)
{
    auto const size = static_cast<Eigen::Index>(touches.size());
    Eigen::MatrixXd jacobian(size, 2);
    Eigen::VectorXd places(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        auto const& touch = touches[static_cast<std::size_t>(i)];
        double const weight = std::sqrt(touch.weight);
        jacobian.row(i) << weight, -weight * (touch.height_mm - mean_height_mm);
        places[i] = weight * touch.position_mm[axis];
    }
    LeastSquares fit;
    Eigen::Matrix2d const normal = small_product(jacobian.transpose(), jacobian);
    fit.unit_covariance = normal.inverse();
    fit.parameters = fit.unit_covariance * (jacobian.transpose() * places);
    fit.residuals = jacobian * fit.parameters - places;
    fit.jacobian = std::move(jacobian);
    return fit;
}

double distance_mm(Touch const& touch, LeastSquares const& x, LeastSquares const& y,
                   double mean_height_mm)
{
    double const height = touch.height_mm - mean_height_mm;
    Vec2 const expected(x.parameters[0] - x.parameters[1] * height,
                        y.parameters[0] - y.parameters[1] * height);
    return (touch.position_mm - expected).norm();
}

// Huber's weights; their scale is from the median distance, which of a circular normal scatter is
// 1.177 standard deviations.
void weigh(std::vector<Touch>& touches, LeastSquares const& x, LeastSquares const& y,
           double mean_height_mm)
{
    std::vector<double> distances;
    for (auto const& touch : touches)
        distances.push_back(distance_mm(touch, x, y, mean_height_mm));
    auto sorted = distances;
    auto const middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    double const reach_mm = kHuberDeviations * 1.414 * std::max(*middle / 1.177, 1e-6);
    for (std::size_t i = 0; i < touches.size(); ++i)
        touches[i].weight = distances[i] > reach_mm ? reach_mm / distances[i] : 1;
}

Result<double> check_rise(std::vector<Touch> const& touches)
{
    if (touches.size() < kLeastTravelTouches)
        return fail(Fault::User,
                    fmt::format("the pen touched in only {} reports with a height, expected at "
                                "least {}: hold it on the tablet and against the edge while the "
                                "surface moves",
                                touches.size(), kLeastTravelTouches));
    auto const [low, high]
        = std::minmax_element(touches.begin(), touches.end(), [](auto const& a, auto const& b) {
              return a.height_mm < b.height_mm;
          });
    double const rise_mm = high->height_mm - low->height_mm;
    if (rise_mm < kLeastTravelRise_mm)
        return fail(Fault::User,
                    fmt::format("the surface moved by only {:.0f} mm while the pen touched, "
                                "expected at least {}: move it over most of its travel",
                                rise_mm, kLeastTravelRise_mm));
    return rise_mm;
}

} // namespace

Result<TravelFit> fit_travel(std::span<PenSample const> pens, std::span<HeightSample const> heights,
                             Rig const& rig)
{
    constexpr int kRounds = 10;
    auto touches = touches_with_height(pens, heights, rig);
    TravelFit result { .rise_mm = TRY(check_rise(touches)), .touches = touches.size() };
    double mean_height_mm = 0;
    std::vector<int> stretches;
    for (auto const& touch : touches) {
        mean_height_mm += touch.height_mm / static_cast<double>(touches.size());
        stretches.push_back(touch.stretch);
    }
    auto x = fit_axis(touches, 0, mean_height_mm);
    auto y = fit_axis(touches, 1, mean_height_mm);
    for (int round = 0; round < kRounds; ++round) {
        weigh(touches, x, y, mean_height_mm);
        x = fit_axis(touches, 0, mean_height_mm);
        y = fit_axis(touches, 1, mean_height_mm);
    }
    result.rms_mm = std::sqrt((x.sum_of_squares() + y.sum_of_squares())
                              / static_cast<double>(touches.size()));
    if (result.rms_mm > kMostStray_mm)
        return fail(Fault::User,
                    fmt::format("the pen strayed {:.1f} mm from a straight line, expected at most "
                                "{}: keep it against the edge all the time, and the edge fixed",
                                result.rms_mm, kMostStray_mm));
    result.shear = { x.parameters[1], y.parameters[1] };
    result.shear_error = { std::sqrt(block_covariance(x, stretches)(1, 1)),
                           std::sqrt(block_covariance(y, stretches)(1, 1)) };
    double const slope = result.shear.norm();
    double const slope_error = slope > 0
        ? result.shear.cwiseProduct(result.shear_error).norm() / slope
        : result.shear_error.norm();
    result.tilt_rad = std::atan(slope);
    result.tilt_error_rad = slope_error / (1 + slope * slope);
    return result;
}

} // namespace tractus
