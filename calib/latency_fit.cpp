#include "calib/latency_fit.h"

#include "calib/least_squares.h"
#include "calib/pen_track.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>
#include <vector>

namespace tractus::calib {

namespace {

constexpr std::size_t kMinLatencyTouches = 200;
constexpr double kMinLatencyRise_mm = 50;
constexpr double kMinRun_mm = 20;
constexpr double kTurn_mm = 20; // A movement back of at least this much counts as a turn.
constexpr int kMinTurns = 2;
constexpr double kMinCorrelation = 0.9;
constexpr int kFarthest_ms = 150;
constexpr int kStep_ms = 2;
// Speeds are measured from this long before an instant to this long after it.
constexpr Duration kSpeedOver = std::chrono::milliseconds(10);
// Below this speed, drag and slack have not yet adapted to a change of direction.
constexpr double kSlow_mm_per_s = 30;

// Heights at whole milliseconds, because each is needed hundreds of times. Linear interpolation
// between them is sufficient: the heights are smoothed over 36 times that interval.
class HeightTable {
public:
    HeightTable(HeightTrack const& track, Timestamp first, Timestamp last)
        : first_(first)
    {
        for (auto time = first; time <= last + kSpacing; time += kSpacing)
            heights_mm_.push_back(
                height_between(track, time).value_or(std::numeric_limits<double>::quiet_NaN()));
    }

    // Returns the height; no value if there are no readings nearby.
    std::optional<double> at(Timestamp time) const
    {
        double const place = to_seconds(time - first_) / to_seconds(kSpacing);
        if (!(place >= 0 && place < static_cast<double>(heights_mm_.size()) - 1))
            return std::nullopt;
        auto const i = static_cast<std::size_t>(place);
        double const part = place - static_cast<double>(i);
        double const height = (1 - part) * heights_mm_[i] + part * heights_mm_[i + 1];
        return std::isfinite(height) ? std::optional(height) : std::nullopt;
    }

private:
    static constexpr Duration kSpacing = std::chrono::milliseconds(1);

    Timestamp first_;
    std::vector<double> heights_mm_;
};

struct Data {
    std::vector<TouchPoint> touches;
    HeightTable heights;
};

// Collects the touches that have a height for every delay that is tried, so that all delays are
// compared with the same touches.
Data data_of(std::span<drivers::PenSample const> pens,
             std::span<drivers::HeightSample const> heights, Rig rig)
{
    rig.tablet_latency = rig.height_latency = Duration {};
    rig.sample_times = SampleTimes::Evened;
    auto const points = touch_points(pens, rig);
    if (points.empty())
        return { {}, HeightTable(HeightTrack(Duration {}), {}, {}) };
    auto const farthest = std::chrono::milliseconds(kFarthest_ms + kStep_ms) + kSpeedOver;
    HeightTable const table(height_track(heights, rig), points.front().time - farthest,
                            points.back().time + farthest);
    Data data { {}, table };
    for (auto const& point : points)
        if (table.at(point.time) && table.at(point.time - farthest)
            && table.at(point.time + farthest))
            data.touches.push_back(point);
    return data;
}

// Returns the heights that belong to the touches if the pen lags the height by `delay_ms`. No value
// if the height for a touch is missing.
std::optional<Eigen::VectorXd> heights_at(Data const& data, double delay_ms)
{
    Eigen::VectorXd heights(static_cast<Eigen::Index>(data.touches.size()));
    for (std::size_t i = 0; i < data.touches.size(); ++i) {
        auto const height = data.heights.at(data.touches[i].time - from_seconds(delay_ms / 1000));
        if (!height)
            return std::nullopt;
        heights[static_cast<Eigen::Index>(i)] = *height;
    }
    return heights;
}

// Returns the surface's direction at the touches, from -1 to 1, and near 0 where it turns.
std::optional<Eigen::VectorXd> directions_at(Data const& data, double delay_ms)
{
    auto const before = heights_at(data, delay_ms + 1000 * to_seconds(kSpeedOver));
    auto const after = heights_at(data, delay_ms - 1000 * to_seconds(kSpeedOver));
    if (!before || !after)
        return std::nullopt;
    double const over_s = 2 * to_seconds(kSpeedOver);
    return ((*after - *before).array() / (over_s * kSlow_mm_per_s)).tanh();
}

Eigen::MatrixX2d places_of(Data const& data)
{
    Eigen::MatrixX2d places(static_cast<Eigen::Index>(data.touches.size()), 2);
    for (std::size_t i = 0; i < data.touches.size(); ++i)
        places.row(static_cast<Eigen::Index>(i)) = data.touches[i].position_mm.transpose();
    return places;
}

// The edge as the tablet sees it: position = start_mm + run_per_rise * height.
struct Edge {
    Vec2 start_mm = Vec2::Zero();
    Vec2 run_per_rise = Vec2::Zero();
    double correlation = 0;
};

Edge edge_at(Eigen::MatrixX2d const& places, Eigen::VectorXd const& heights)
{
    Eigen::RowVector2d const mean_place = places.colwise().mean();
    double const mean_height = heights.mean();
    Eigen::VectorXd const rises = heights.array() - mean_height;
    Eigen::MatrixX2d const ways = places.rowwise() - mean_place;
    Vec2 const run = ways.transpose() * rises / std::max(rises.squaredNorm(), 1e-12);
    double const explained = run.squaredNorm() * rises.squaredNorm();
    return { .start_mm = mean_place.transpose() - run * mean_height,
             .run_per_rise = run,
             .correlation = std::sqrt(explained / std::max(ways.squaredNorm(), 1e-12)) };
}

int count_turns(Eigen::VectorXd const& heights)
{
    int turns = 0;
    double direction = 0;
    double farthest = heights[0];
    for (double const height : heights) {
        if (direction == 0 && std::abs(height - farthest) > kTurn_mm) {
            direction = height > farthest ? 1 : -1;
            farthest = height;
        } else if (direction != 0 && direction * (height - farthest) > 0) {
            farthest = height;
        } else if (direction != 0 && direction * (farthest - height) > kTurn_mm) {
            ++turns;
            direction = -direction;
            farthest = height;
        }
    }
    return turns;
}

Result<void> check_movement(Data const& data)
{
    if (data.touches.size() < kMinLatencyTouches)
        return fail(Fault::User,
                    fmt::format("the pen touched in only {} reports with a height, expected at "
                                "least {}: let it follow the edge for ten seconds or more",
                                data.touches.size(), kMinLatencyTouches));
    auto const heights = heights_at(data, 0).value();
    if (double const rise_mm = heights.maxCoeff() - heights.minCoeff();
        rise_mm < kMinLatencyRise_mm)
        return fail(Fault::User,
                    fmt::format("the surface moved by only {:.0f} mm while the pen touched, "
                                "expected at least {}: move it further",
                                rise_mm, kMinLatencyRise_mm));
    if (int const turns = count_turns(heights); turns < kMinTurns)
        return fail(Fault::User,
                    fmt::format("the surface turned {} times while the pen touched, expected at "
                                "least {}: move it up and down several times",
                                turns, kMinTurns));
    return {};
}

double run_of(Eigen::MatrixX2d const& places, Edge const& edge)
{
    Eigen::VectorXd const along = places * edge.run_per_rise.normalized();
    return along.maxCoeff() - along.minCoeff();
}

Result<int> coarse_delay_ms(Data const& data, Eigen::MatrixX2d const& places)
{
    int best_ms = 0;
    double best = -1;
    for (int delay_ms = -kFarthest_ms; delay_ms <= kFarthest_ms; delay_ms += kStep_ms) {
        auto const edge = edge_at(places, heights_at(data, delay_ms).value());
        if (edge.correlation > best) {
            best = edge.correlation;
            best_ms = delay_ms;
        }
    }
    if (best < kMinCorrelation)
        return fail(Fault::User,
                    fmt::format("the pen's place and the height do not belong together "
                                "(correlation {:.2f}, expected at least {}): keep the pen against "
                                "one inclined edge that does not move",
                                best, kMinCorrelation));
    if (std::abs(best_ms) == kFarthest_ms)
        return fail(Fault::User,
                    fmt::format("pen and height differ by {} ms or more: check that both devices "
                                "are connected directly, then try again",
                                kFarthest_ms));
    return best_ms;
}

// Fits the edge, the delay and the effect of the direction together. The parameters are start x, y;
// run x, y; delay in milliseconds; half the distance between up and down x, y.
std::optional<LeastSquares> refine(Data const& data, Eigen::MatrixX2d const& places, int start_ms)
{
    auto const edge = edge_at(places, heights_at(data, start_ms).value());
    auto const residuals
        = [&](Eigen::VectorXd const& parameters) -> std::optional<Eigen::VectorXd> {
        auto const heights = heights_at(data, parameters[4]);
        auto const directions = directions_at(data, parameters[4]);
        if (!heights || !directions)
            return std::nullopt;
        Eigen::VectorXd misses(2 * heights->size());
        for (Eigen::Index i = 0; i < heights->size(); ++i)
            for (int axis = 0; axis < 2; ++axis)
                misses[2 * i + axis] = parameters[axis] + parameters[2 + axis] * (*heights)[i]
                    + parameters[5 + axis] * (*directions)[i] - places(i, axis);
        return misses;
    };
    Eigen::VectorXd start(7);
    start << edge.start_mm, edge.run_per_rise, start_ms, 0, 0;
    // The delay needs a large step, because times are rounded to nanoseconds and heights are
    // piecewise linear.
    Eigen::VectorXd steps(7);
    steps << 1e-3, 1e-3, 1e-6, 1e-6, 0.5, 1e-3, 1e-3;
    return fit_least_squares(residuals, start, steps);
}

} // namespace

Result<LatencyFit> fit_latency(std::span<drivers::PenSample const> pens,
                               std::span<drivers::HeightSample const> heights, Rig const& rig)
{
    auto const data = data_of(pens, heights, rig);
    TRY(check_movement(data));
    auto const places = places_of(data);
    int const coarse_ms = TRY(coarse_delay_ms(data, places));
    auto const edge = edge_at(places, heights_at(data, coarse_ms).value());
    double const run_mm = run_of(places, edge);
    if (run_mm < kMinRun_mm)
        return fail(Fault::User,
                    fmt::format("the pen went only {:.0f} mm along the tablet, expected at least "
                                "{}: incline the edge more, 45 degrees say",
                                run_mm, kMinRun_mm));
    auto const fit = refine(data, places, coarse_ms);
    if (!fit)
        return fail(Fault::User, "the delay cannot be told: record the movement again");
    std::vector<int> stretches;
    for (auto const& touch : data.touches)
        stretches.insert(stretches.end(), 2, stretch_of(touch.time));
    auto const covariance = block_covariance(*fit, stretches);
    Vec2 const along = edge.run_per_rise.normalized();
    return LatencyFit {
        .delay_ms = fit->parameters[4],
        .error_ms = std::sqrt(covariance(4, 4)),
        .direction_mm = 2 * along.dot(fit->parameters.segment<2>(5)),
        .direction_error_mm = 2 * std::sqrt(along.dot(covariance.block<2, 2>(5, 5) * along)),
        .correlation = edge.correlation,
        .rms_mm = std::sqrt(fit->sum_of_squares() / static_cast<double>(data.touches.size())),
        .run_mm = run_mm,
        .touches = data.touches.size(),
    };
}

Rig with_delay(Rig rig, LatencyFit const& fit)
{
    auto const delay = from_seconds(fit.delay_ms / 1000);
    rig.sample_times = SampleTimes::Evened;
    rig.tablet_latency = std::max(rig.height_latency + delay, Duration {});
    rig.height_latency = rig.tablet_latency - delay;
    return rig;
}

} // namespace tractus::calib
