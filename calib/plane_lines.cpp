#include "calib/plane_lines.h"

#include "calib/least_squares.h"
#include "engine/base/check.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tractus::calib {

namespace {

// Huber's constant, for 95 % efficiency without outliers.
constexpr double kHuberDeviations = 1.345;
constexpr int kRounds = 10;

using Sightings = std::span<PlaneSighting const>;

// Fits the x coordinate (axis 0) or y coordinate (axis 1) by weighted least squares.
LeastSquares fit_axis(Sightings sightings, std::vector<double> const& weights, int axis,
                      Vec2 const& mean)
{
    auto const size = static_cast<Eigen::Index>(sightings.size());
    Eigen::MatrixXd jacobian(size, 2);
    Eigen::VectorXd places(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        auto const& sighting = sightings[static_cast<std::size_t>(i)];
        double const weight = std::sqrt(weights[static_cast<std::size_t>(i)]);
        jacobian.row(i) << weight, weight * (sighting.against[axis] - mean[axis]);
        places[i] = weight * sighting.position_mm[axis];
    }
    LeastSquares fit;
    Eigen::Matrix2d const normal = small_product(jacobian.transpose(), jacobian);
    fit.unit_covariance = normal.inverse();
    fit.parameters = fit.unit_covariance * (jacobian.transpose() * places);
    fit.residuals = jacobian * fit.parameters - places;
    fit.jacobian = std::move(jacobian);
    return fit;
}

Vec2 miss_mm(PlaneSighting const& sighting, LeastSquares const& x, LeastSquares const& y,
             Vec2 const& mean)
{
    Vec2 const way = sighting.against - mean;
    Vec2 const expected(x.parameters[0] + x.parameters[1] * way.x(),
                        y.parameters[0] + y.parameters[1] * way.y());
    return sighting.position_mm - expected;
}

// Computes Huber's weights; their scale comes from the median distance, which for a circular normal
// distribution is 1.177 standard deviations.
void weigh(std::vector<double>& weights, std::vector<Vec2> const& misses)
{
    std::vector<double> sorted;
    sorted.reserve(misses.size());
    for (auto const& miss : misses)
        sorted.push_back(miss.norm());
    auto const middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    double const reach_mm = kHuberDeviations * 1.414 * std::max(*middle / 1.177, 1e-6);
    for (std::size_t i = 0; i < misses.size(); ++i) {
        double const distance_mm = misses[i].norm();
        weights[i] = distance_mm > reach_mm ? reach_mm / distance_mm : 1;
    }
}

} // namespace

PlaneLines fit_plane_lines(Sightings sightings)
{
    CHECK(!sightings.empty());
    auto const count = static_cast<double>(sightings.size());
    Vec2 mean = Vec2::Zero();
    std::vector<int> stretches;
    for (auto const& sighting : sightings) {
        mean += sighting.against / count;
        stretches.push_back(sighting.stretch);
    }
    std::vector<double> weights(sightings.size(), 1);
    PlaneLines lines { .misses_mm = std::vector<Vec2>(sightings.size()) };
    auto x = fit_axis(sightings, weights, 0, mean);
    auto y = fit_axis(sightings, weights, 1, mean);
    auto const find_misses = [&] {
        std::transform(sightings.begin(), sightings.end(), lines.misses_mm.begin(),
                       [&](PlaneSighting const& one) { return miss_mm(one, x, y, mean); });
    };
    for (int round = 0; round < kRounds; ++round) {
        find_misses();
        weigh(weights, lines.misses_mm);
        x = fit_axis(sightings, weights, 0, mean);
        y = fit_axis(sightings, weights, 1, mean);
    }
    find_misses();
    lines.place_mm = { x.parameters[0], y.parameters[0] };
    lines.slope = { x.parameters[1], y.parameters[1] };
    lines.slope_error = { std::sqrt(block_covariance(x, stretches)(1, 1)),
                          std::sqrt(block_covariance(y, stretches)(1, 1)) };
    lines.rms_mm = std::sqrt((x.sum_of_squares() + y.sum_of_squares()) / count);
    return lines;
}

} // namespace tractus::calib
