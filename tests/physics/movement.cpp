#include "tests/physics/movement.h"

#include "calib/fuser.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tractus::physics {

namespace {

constexpr double kCountsPerMm = 10;

Timestamp at(double seconds)
{
    return Timestamp(std::chrono::nanoseconds(std::llround(seconds * 1e9)));
}

// Returns the times at which bursts arrive; no times if samples arrive one by one.
std::vector<double> delivery_times_s(Sampling const& sampling, Dice& dice)
{
    std::vector<double> times_s;
    if (sampling.burst_s > 0)
        for (double t = 0; t<sampling.seconds + sampling.burst_s + sampling.most_burst_s;
                             t += sampling.most_burst_s>
                               sampling.burst_s
                 ? uniform(dice, sampling.burst_s, sampling.most_burst_s)
                 : sampling.burst_s)
            times_s.push_back(t);
    return times_s;
}

double arrival_s(double seconds, std::vector<double> const& deliveries_s)
{
    auto const next = std::lower_bound(deliveries_s.begin(), deliveries_s.end(), seconds);
    return next == deliveries_s.end() ? seconds : *next;
}

bool is_lost(Sampling const& sampling, Dice& dice)
{
    return sampling.lost_part > 0 && uniform(dice, 0, 1) < sampling.lost_part;
}

std::vector<drivers::HeightSample> height_samples(Movement const& movement,
                                                  Sampling const& sampling,
                                                  std::vector<double> const& deliveries_s,
                                                  Dice& dice)
{
    std::vector<drivers::HeightSample> samples;
    double const phase_s = uniform(dice, 0, 1 / sampling.height_hz);
    for (double t = phase_s; t < sampling.seconds; t += 1 / sampling.height_hz) {
        if ((t >= sampling.gap_from_s && t < sampling.gap_to_s) || is_lost(sampling, dice))
            continue;
        double counts = kCountsPerMm * movement(t) + normal(dice, sampling.noise_counts);
        if (uniform(dice, 0, 1) < sampling.spike_part)
            counts += 30 * kCountsPerMm * (uniform(dice, 0, 1) < 0.5 ? -1 : 1);
        samples.push_back({ .time = at(arrival_s(t, deliveries_s)),
                            .counts = std::clamp(static_cast<int>(std::lround(counts)), 0, 4095),
                            .full_scale = 4095 });
    }
    return samples;
}

std::vector<drivers::PenSample> pen_samples(Sampling const& sampling,
                                            std::vector<double> const& deliveries_s, Dice& dice)
{
    std::vector<drivers::PenSample> samples;
    double const phase_s = uniform(dice, 0, 1 / sampling.pen_hz);
    for (double t = phase_s; t < sampling.seconds; t += 1 / sampling.pen_hz)
        if (!is_lost(sampling, dice))
            samples.push_back({ .time = at(arrival_s(t, deliveries_s)),
                                // The position encodes the time at which the pen was there.
                                .position_mm = { t, 0 },
                                .pressure = 1,
                                .in_range = true,
                                .touching = true });
    return samples;
}

Tip tip_of(TipSample const& tip, Movement const& movement, calib::Rig const& rig)
{
    double const seconds = tip.position_mm.x() + rig.tablet_size_mm.x() / 2;
    return { .seconds = seconds,
             .error_mm = tip.position_mm.z() - movement(seconds),
             .is_extrapolated = tip.height_source == TipSample::HeightSource::Extrapolated };
}

} // namespace

Tips fuse(Movement const& movement, Sampling const& sampling, Dice& dice)
{
    calib::Rig rig;
    rig.height_model = calib::LinearHeight { .mm_per_count = 1 / kCountsPerMm, .zero_counts = 0 };
    rig.sample_times = sampling.sample_times;
    calib::Fuser fuser(rig);
    auto const deliveries_s = delivery_times_s(sampling, dice);
    auto const heights = height_samples(movement, sampling, deliveries_s, dice);
    Tips tips;
    auto const settle = [&] {
        for (auto const& tip : fuser.take_settled())
            tips.settled.push_back(tip_of(tip, movement, rig));
    };
    std::size_t next = 0;
    for (auto const& pen : pen_samples(sampling, deliveries_s, dice)) {
        auto const came_before = [&](drivers::HeightSample const& height) {
            return height.time < pen.time || (height.time == pen.time && !sampling.pens_come_first);
        };
        for (; next < heights.size() && came_before(heights[next]); ++next)
            fuser.push(heights[next]);
        if (auto const live = fuser.push(pen))
            tips.live.push_back(tip_of(*live, movement, rig));
        settle();
    }
    for (; next < heights.size(); ++next)
        fuser.push(heights[next]);
    fuser.flush();
    settle();
    return tips;
}

Movement sway(double speed_mm_per_s)
{
    constexpr double kPerSecond = 2 * std::numbers::pi * 0.6;
    return [=](double t) { return 200 + speed_mm_per_s / kPerSecond * std::sin(kPerSecond * t); };
}

Movement stop(double speed_mm_per_s, double stopping_s)
{
    return [=](double t) {
        double const since = std::clamp(t - 1, 0.0, std::max(stopping_s, 1e-9));
        double const braked = stopping_s > 0 ? since - since * since / (2 * stopping_s) : 0;
        return 20 + speed_mm_per_s * (std::min(t, 1.0) + braked);
    };
}

} // namespace tractus::physics
