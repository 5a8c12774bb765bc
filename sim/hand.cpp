#include "sim/hand.h"

#include "engine/base/check.h"
#include "engine/base/random.h"
#include "sim/random_streams.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::sim {

static constexpr double kMoveSpeed_mm_s = 250;
// Pause out of range before the first stroke and after the last one.
static constexpr Duration kAbsence = std::chrono::milliseconds(200);

// In moves to the next stroke that take longer than kLongMove_s, the pen is lifted high, except for
// kLowMoment_s at either end.
static constexpr double kLongMove_s = 0.4;
static constexpr double kLowMoment_s = 0.1;

static constexpr double kPressureRamp_s = 0.04;
static constexpr double kMinPressure = 0.02;

SpeedProfile::SpeedProfile(double length_mm, double cruise_mm_s)
    : length_mm_(length_mm)
    , cruise_mm_s_(cruise_mm_s)
{
    CHECK(length_mm > 0 && cruise_mm_s > 0);
    // Distance covered while accelerating and decelerating.
    double const ramps_mm = cruise_mm_s * kRamp_s;
    if (cruises())
        duration_s_ = 2 * kRamp_s + (length_mm - ramps_mm) / cruise_mm_s;
    // The quintic's peak is 15/8 of its mean speed. With equal jerk, the time grows with the cube
    // root of the distance.
    else
        duration_s_ = 15.0 / 8 * kRamp_s * std::cbrt(length_mm / ramps_mm);
}

double SpeedProfile::distance_mm(double seconds) const
{
    double const t = std::clamp(seconds, 0.0, duration_s_);
    if (!cruises()) {
        double const u = t / duration_s_;
        return length_mm_ * u * u * u * (10 + u * (6 * u - 15));
    }
    // Integral of the speed during acceleration, see speed_mm_s().
    auto const ramp_mm = [&](double u) { return cruise_mm_s_ * kRamp_s * u * u * u * (1 - u / 2); };
    if (t < kRamp_s)
        return ramp_mm(t / kRamp_s);
    if (t > duration_s_ - kRamp_s)
        return length_mm_ - ramp_mm((duration_s_ - t) / kRamp_s);
    return cruise_mm_s_ * (t - kRamp_s / 2);
}

double SpeedProfile::speed_mm_s(double seconds) const
{
    double const t = std::clamp(seconds, 0.0, duration_s_);
    if (!cruises()) {
        double const u = t / duration_s_;
        return 30 * length_mm_ / duration_s_ * u * u * (1 - u) * (1 - u);
    }
    // Changes speed with minimum jerk: the cubic with zero acceleration at its ends.
    double const u = std::min({ 1.0, t / kRamp_s, (duration_s_ - t) / kRamp_s });
    return cruise_mm_s_ * u * u * (3 - 2 * u);
}

Hand::Hand(std::vector<HandStroke> strokes, HandOptions const& options)
    : options_(options)
    , strokes_(std::move(strokes))
{
    CHECK(!strokes_.empty());
    rest(HandPhase::Absent, strokes_.front().path.points_mm().front(), kAbsence, 0);
    for (std::size_t i = 0; i < strokes_.size(); ++i)
        draw(i);
    rest(HandPhase::Absent, strokes_.back().path.points_mm().back(), kAbsence, strokes_.size() - 1);
    make_tremor();
}

void Hand::rest(HandPhase doing, Vec3 const& place_mm, Duration length, std::size_t stroke)
{
    parts_.push_back({ .doing = doing,
                       .start = end_,
                       .duration_s = to_seconds(length),
                       .rest_mm = place_mm,
                       .stroke = stroke });
    end_ += length;
}

void Hand::go(HandPhase doing, Path path, double cruise_mm_s, std::size_t stroke)
{
    SpeedProfile const profile(path.length_mm(), cruise_mm_s);
    parts_.push_back({ .doing = doing,
                       .start = end_,
                       .duration_s = profile.duration_s(),
                       .path = std::move(path),
                       .profile = profile,
                       .stroke = stroke });
    end_ += from_seconds(profile.duration_s());
}

// Adds the parts of a stroke: the hand moves from the end of the previous stroke, hovers, draws and
// hovers.
void Hand::draw(std::size_t stroke)
{
    auto const& path = strokes_[stroke].path;
    Vec3 const start_mm = path.points_mm().front();
    StrokeTimes times { .chosen = end_ };
    if (stroke > 0) {
        Vec3 const from_mm = strokes_[stroke - 1].path.points_mm().back();
        if (from_mm != start_mm) {
            Path const way({ from_mm, start_mm });
            go(HandPhase::Move, way, cruise_mm_s(way, kMoveSpeed_mm_s), stroke);
        }
    }
    times.chosen += (end_ - times.chosen) / 2;
    rest(HandPhase::Hover, start_mm, options_.pause, stroke);
    times.down = end_;
    go(HandPhase::Draw, path, cruise_mm_s(path, strokes_[stroke].speed_mm_s), stroke);
    times.up = end_;
    rest(HandPhase::Hover, path.points_mm().back(), options_.pause, stroke);
    stroke_times_.push_back(times);
}

// Returns the greatest speed, up to `speed_mm_s`, at which the hand exceeds no speed limit of its
// options on any segment of the path.
double Hand::cruise_mm_s(Path const& path, double speed_mm_s) const
{
    double limit = speed_mm_s;
    auto const& points = path.points_mm();
    for (std::size_t i = 1; i < points.size(); ++i) {
        Vec3 const direction = (points[i] - points[i - 1]).normalized();
        constexpr double kMin = 1e-9;
        limit = std::min(
            limit, options_.max_plane_speed_mm_s / std::max(direction.head<2>().norm(), kMin));
        limit = std::min(limit,
                         options_.max_height_speed_mm_s / std::max(std::abs(direction.z()), kMin));
    }
    return limit;
}

// Makes the tremor: sines of equal amplitude with random frequencies in the tremor's band.
void Hand::make_tremor()
{
    Random random({ .seed = options_.seed, .stream = kTremorStream });
    for (std::size_t axis = 0; axis < tremor_.size(); ++axis) {
        double const deviation_mm = axis < 2 ? options_.plane_tremor_mm : options_.height_tremor_mm;
        double const count = static_cast<double>(tremor_[axis].size());
        for (auto& wave : tremor_[axis])
            wave = { .amplitude_mm = deviation_mm * std::sqrt(2 / count),
                     .rad_per_s
                     = 2 * kPi * random.uniform(options_.min_tremor_hz, options_.most_tremor_hz),
                     .phase_rad = random.uniform(0, 2 * kPi) };
    }
}

void Hand::add_tremor(HandState& state, double seconds) const
{
    for (std::size_t axis = 0; axis < tremor_.size(); ++axis) {
        auto const i = static_cast<Eigen::Index>(axis);
        for (auto const& wave : tremor_[axis]) {
            double const angle = wave.rad_per_s * seconds + wave.phase_rad;
            state.position_mm[i] += wave.amplitude_mm * std::sin(angle);
            state.velocity_mm_s[i] += wave.amplitude_mm * wave.rad_per_s * std::cos(angle);
        }
    }
}

// Varies the pressure slowly, and lets it rise and fall smoothly at the ends of a stroke.
void Hand::press(HandState& state, Part const& part, double seconds) const
{
    double const to_end_s = std::min(seconds, part.duration_s - seconds);
    double const u = std::clamp(to_end_s / kPressureRamp_s, 0.0, 1.0);
    double const ramp = u * u * (3 - 2 * u);
    double const wander = 1 + 0.15 * std::sin(2 * kPi * 0.7 * seconds);
    state.touching = true;
    state.pressure = std::clamp(strokes_[part.stroke].pressure * ramp * wander, kMinPressure, 1.0);
}

HandState Hand::at(Timestamp time) const
{
    auto const now = std::clamp(time, Timestamp {}, end_);
    auto const after
        = std::upper_bound(parts_.begin() + 1, parts_.end(), now,
                           [](Timestamp t, Part const& part) { return t < part.start; });
    auto const& part = *std::prev(after);
    double const seconds = to_seconds(now - part.start);

    HandState state;
    state.position_mm = part.rest_mm;
    if (part.path) {
        double const arc_mm = part.profile.distance_mm(seconds);
        state.position_mm = part.path->position_mm(arc_mm);
        state.velocity_mm_s = part.profile.speed_mm_s(seconds) * part.path->direction(arc_mm);
    }
    add_tremor(state, to_seconds(now));

    bool const lifted = part.doing == HandPhase::Move && part.duration_s > kLongMove_s
        && seconds > kLowMoment_s && part.duration_s - seconds > kLowMoment_s;
    state.in_range = part.doing != HandPhase::Absent && !lifted;
    state.eraser = strokes_[part.stroke].eraser;
    if (part.doing == HandPhase::Draw)
        press(state, part, seconds);
    double const sway = 0.05 * std::sin(2 * kPi * 0.3 * to_seconds(now));
    state.tilt_rad = options_.tilt_rad + Vec2(sway, -sway);
    // The frequencies along the two axes differ, so that the pen leans in all directions.
    if (!options_.leaned_around_rad.isZero(0))
        state.tilt_rad += options_.leaned_around_rad.cwiseProduct(
            Vec2(std::sin(2 * kPi * 0.23 * to_seconds(now)),
                 std::sin(2 * kPi * 0.17 * to_seconds(now))));
    return state;
}

} // namespace tractus::sim
