#include "calib/even_times.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace tractus::calib {
namespace {

Timestamp at(double seconds)
{
    return Timestamp(std::chrono::nanoseconds(std::llround(seconds * 1e9)));
}

double seconds_of(Timestamp time)
{
    return to_seconds(time.time_since_epoch());
}

// A sample with the time at which it was taken and its arrival.
struct Sample {
    double taken_s = 0;
    double arrival_s = 0;
};

using Delivery = std::function<double(double taken_s)>;

std::vector<Sample> samples(double rate_hz, double seconds, Delivery const& delivery)
{
    std::vector<Sample> samples;
    for (double t = 0.0031; t < seconds; t += 1 / rate_hz)
        samples.push_back({ t, delivery(t) });
    return samples;
}

Delivery bursts(double every_s)
{
    return [=](double t) { return std::ceil(t / every_s) * every_s; };
}

// Returns by how much the estimated times are later than the true times, in milliseconds, for
// samples from `from_s` on.
std::vector<double> late_ms(std::vector<Sample> const& samples, double from_s)
{
    EvenTimes times;
    std::vector<double> late;
    for (auto const& sample : samples) {
        auto const told = times.add(at(sample.arrival_s));
        if (sample.taken_s >= from_s)
            late.push_back(1000 * (seconds_of(told) - sample.taken_s));
    }
    return late;
}

double most(std::vector<double> const& values)
{
    return *std::max_element(values.begin(), values.end());
}

double least(std::vector<double> const& values)
{
    return *std::min_element(values.begin(), values.end());
}

void expect_arrivals(std::vector<Sample> const& samples)
{
    EvenTimes times;
    for (auto const& sample : samples) {
        EXPECT_EQ(times.add(at(sample.arrival_s)), at(sample.arrival_s)) << sample.taken_s;
        EXPECT_FALSE(times.is_evened());
    }
}

// A burst can deliver only complete samples, so delays take only a few values within a period.
TEST(EvenTimes, PutsWhatBurstsBringOneAfterTheOther)
{
    for (double const every_s : { 0.016, 0.032 })
        for (double const rate_hz : { 133.0, 250.0, 503.0 }) {
            auto const late = late_ms(samples(rate_hz, 5, bursts(every_s)), 1.5);
            EXPECT_LT(most(late), 1000 / rate_hz / 3) << every_s << " s, " << rate_hz << " Hz";
            EXPECT_GT(least(late), -1) << every_s << " s, " << rate_hz << " Hz";
        }
}

TEST(EvenTimes, EvensBurstsAtRandomInstants)
{
    std::mt19937 random(3);
    double next_s = 0;
    auto const late
        = late_ms(samples(133, 5,
                          [&](double t) {
                              while (next_s < t)
                                  next_s += std::uniform_real_distribution<>(0.008, 0.03)(random);
                              return next_s;
                          }),
                  1.5);
    EXPECT_LT(most(late), 1.0);
    EXPECT_GT(least(late), -0.5);
}

// Bursts every 8 ms at 133 Hz contain one sample or, occasionally, two.
TEST(EvenTimes, SeesBurstsThatHardlyHoldMoreThanOne)
{
    auto const late = late_ms(samples(133, 5, bursts(0.008)), 1.5);
    EXPECT_LT(most(late), 0.6);
    EXPECT_GT(least(late), -0.5);
}

TEST(EvenTimes, LeavesWhatComesOneByOneAsItIs)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<> jitter(0, 0.003);
    expect_arrivals(samples(133, 4, [&](double t) { return t + jitter(random); }));
}

// Some tablets report each change when it happens, and not at even intervals.
TEST(EvenTimes, LeavesADeviceThatSamplesUnevenlyAsItIs)
{
    std::mt19937 random(7);
    std::exponential_distribution<> gap(133);
    std::vector<Sample> uneven;
    for (double t = 0.1; t < 20; t += gap(random))
        uneven.push_back({ t, t });
    expect_arrivals(uneven);
}

// The device itself sends bursts, and its rate varies by a tenth within a second.
TEST(EvenTimes, LeavesARateThatWandersAsItIs)
{
    std::vector<Sample> wandering;
    for (double t = 0; t < 20; t += (1 + 0.1 * std::sin(6.28 * t)) / 133)
        wandering.push_back({ t, std::ceil(t / 0.016) * 0.016 });
    EvenTimes times;
    std::size_t moved = 0;
    for (auto const& sample : wandering)
        moved += times.add(at(sample.arrival_s)) != at(sample.arrival_s);
    EXPECT_LT(moved, wandering.size() / 20);
}

// A loss must be found at the latest after three bursts that it has made late.
TEST(EvenTimes, CountsLostSamples)
{
    auto all = samples(133, 6, bursts(0.016));
    for (double const lost_s : { 2.0, 3.1, 4.2 }) {
        auto const lost = std::find_if(all.begin(), all.end(),
                                       [&](Sample const& one) { return one.taken_s > lost_s; });
        all.erase(lost, lost + 2);
    }
    EvenTimes times;
    for (auto const& sample : all) {
        double const late
            = 1000 * seconds_of(times.add(at(sample.arrival_s))) - 1000 * sample.taken_s;
        bool const is_settling
            = std::fmod(sample.taken_s - 2.0 + 1.1, 1.1) < 0.05 || sample.taken_s < 1.5;
        if (!is_settling) {
            EXPECT_LT(std::abs(late), 1.0) << sample.taken_s;
        }
    }
}

// A loss while the period is learnt must delay the learning, and must not change the period.
TEST(EvenTimes, LearnsTheRateFromTheFirstHalfSecondWithoutALoss)
{
    auto all = samples(497, 4, bursts(0.016));
    for (double const lost_s : { 0.36, 0.57 }) {
        auto const lost = std::find_if(all.begin(), all.end(),
                                       [&](Sample const& one) { return one.taken_s > lost_s; });
        all.erase(lost, lost + 2);
    }
    EXPECT_LT(most(late_ms(all, 1.16)), 1);
    EXPECT_GT(least(late_ms(all, 1.16)), -1);
}

TEST(EvenTimes, CountsSamplesThatAreOneTooMany)
{
    auto all = samples(133, 6, bursts(0.016));
    auto const twice
        = std::find_if(all.begin(), all.end(), [](Sample const& one) { return one.taken_s > 3; });
    all.insert(twice, *twice);
    EvenTimes times;
    for (auto const& sample : all) {
        double const late
            = 1000 * seconds_of(times.add(at(sample.arrival_s))) - 1000 * sample.taken_s;
        if (sample.taken_s > 1.5 && (sample.taken_s < 3 || sample.taken_s > 3.05)) {
            EXPECT_LT(std::abs(late), 1.0) << sample.taken_s;
        }
    }
}

// While a pen is away, the phase of the device's samples changes. The first samples after the pen's
// return are not corrected.
TEST(EvenTimes, FindsAgainWhereSamplesFallAfterASilence)
{
    auto all = samples(133, 2, bursts(0.016));
    for (double t = 2.4137; t < 4; t += 1 / 133.0)
        all.push_back({ t, std::ceil(t / 0.016) * 0.016 });
    EvenTimes times;
    for (auto const& sample : all) {
        double const late
            = 1000 * seconds_of(times.add(at(sample.arrival_s))) - 1000 * sample.taken_s;
        EXPECT_GT(late, -1);
        EXPECT_LE(late, 17);
        if (sample.taken_s > 2.6) {
            EXPECT_LT(late, 1.5) << sample.taken_s;
        }
    }
}

TEST(EvenTimes, NeverRunsBackNorAheadOfArrivals)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<> of_one(0, 1);
    EvenTimes times;
    double arrival_s = 0;
    Timestamp last = at(-1);
    for (int i = 0; i < 5000; ++i) {
        double const dice = of_one(random);
        arrival_s += dice < 0.6 ? 1e-4 : dice < 0.99 ? 0.02 : 0.3;
        auto const told = times.add(at(arrival_s));
        EXPECT_GT(told, last);
        EXPECT_LE(told, at(arrival_s) + std::chrono::milliseconds(1));
        last = told;
    }
}

TEST(EvenTimes, BeginsAnewWhenTheClockJumpsBack)
{
    EvenTimes times;
    for (auto const& sample : samples(133, 3, bursts(0.016)))
        (void)times.add(at(100 + sample.arrival_s));
    for (auto const& sample : samples(133, 3, bursts(0.016)))
        EXPECT_LE(times.add(at(sample.arrival_s)), at(sample.arrival_s + 0.0001));
}

TEST(EvenTimes, KnowsHowOftenBurstsCome)
{
    EvenTimes times;
    EXPECT_EQ(times.burst_interval(), Duration {});
    for (auto const& sample : samples(487, 3, bursts(0.016)))
        times.add(at(sample.arrival_s));
    EXPECT_NEAR(to_seconds(times.burst_interval()), 0.016, 0.0005);
    EvenTimes steady;
    for (auto const& sample : samples(487, 3, [](double t) { return t + 0.001; }))
        steady.add(at(sample.arrival_s));
    EXPECT_EQ(steady.burst_interval(), Duration {}) << "nothing to wait for";
}

} // namespace
} // namespace tractus::calib
