#include "calib/fuser.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

// Rig with 0.1 mm per count, and the tablet's corner at (-100, -50).
Rig const kRig {
    .height_model = LinearHeight { .mm_per_count = 0.1 },
    .height_latency = 3ms,
    .tablet_size_mm = { 200, 100 },
    .tablet_latency = 8ms,
};

Timestamp at(Duration time)
{
    return Timestamp(time);
}

drivers::HeightSample height(Duration time, int counts)
{
    return { .time = at(time), .counts = counts, .full_scale = 4095 };
}

drivers::PenSample pen(Duration time, Vec2 position_mm = { 0, 0 })
{
    drivers::PenSample sample;
    sample.time = at(time);
    sample.position_mm = position_mm;
    sample.in_range = sample.touching = true;
    return sample;
}

// Pushes readings every 2 ms of a carriage that rises by 1,000 counts (100 mm) a second. It starts
// at count 0 at time 0.
void push_rise(Fuser& fuser, Duration from, Duration to)
{
    for (auto time = from; time < to; time += 2ms)
        fuser.push(height(time + kRig.height_latency, static_cast<int>(time / 1ms)));
}

TEST(Fuser, HasNoTipUntilAHeightHasCome)
{
    Fuser fuser(kRig);
    EXPECT_FALSE(fuser.push(pen(10ms)));
    fuser.push(height(10ms, 100));
    EXPECT_TRUE(fuser.push(pen(11ms)));
}

TEST(Fuser, TakesBothLatenciesOff)
{
    Fuser fuser(kRig);
    push_rise(fuser, 0ms, 200ms);
    // The pen was at its position at 100 ms, when the reading was 100 counts.
    auto const tip = fuser.push(pen(108ms));
    ASSERT_TRUE(tip);
    EXPECT_EQ(tip->time, at(100ms));
    EXPECT_NEAR(tip->position_mm.z(), 10, 1e-9);
    EXPECT_EQ(tip->height_source, TipSample::HeightSource::Interpolated);
}

// With the tablet rotated by 90 degrees, a pen that leans to the right on the tablet leans away
// from the user in the world.
TEST(Fuser, TurnsThePensTiltWithTheTablet)
{
    auto rig = kRig;
    rig.rotation_deg = 90;
    Fuser fuser(rig);
    fuser.push(height(8ms, 1000));
    EXPECT_FALSE(fuser.push(pen(10ms))->tilt_rad) << "the tablet tells none";
    auto leaning = pen(11ms);
    leaning.tilt_rad = Vec2(0.4, 0.1);
    auto const tip = fuser.push(leaning);
    ASSERT_TRUE(tip && tip->tilt_rad);
    EXPECT_NEAR((*tip->tilt_rad - Vec2(-0.1, 0.4)).norm(), 0, 1e-12);
}

TEST(Fuser, PutsTheTipInTheWorld)
{
    auto rig = kRig;
    rig.rotation_deg = 90;
    rig.travel_shear = { 0.1, 0 };
    Fuser fuser(rig);
    fuser.push(height(8ms, 1000));
    auto const tip = fuser.push(pen(10ms, { 200, 50 }));
    ASSERT_TRUE(tip);
    EXPECT_LT((tip->position_mm - Vec3(10, 100, 100)).norm(), 1e-9) << tip->position_mm.transpose();
}

TEST(Fuser, CarriesTheHeightOnForLiveInk)
{
    Fuser fuser(kRig);
    push_rise(fuser, 0ms, 101ms);            // Pushes readings up to 100 ms.
    auto const tip = fuser.push(pen(113ms)); // The pen was there at 105 ms, after the last reading.
    ASSERT_TRUE(tip);
    EXPECT_NEAR(tip->position_mm.z(), 10.5, 1e-9);
    EXPECT_EQ(tip->height_source, TipSample::HeightSource::Extrapolated);
    EXPECT_NEAR(fuser.push(pen(123ms))->position_mm.z(), 10.5, 1e-9) << "held, for want of news";
}

TEST(Fuser, HasNoLiveTipWhenTheLastHeightIsTooOld)
{
    Fuser fuser(kRig);
    push_rise(fuser, 0ms, 101ms);
    EXPECT_TRUE(fuser.push(pen(158ms)));
    EXPECT_FALSE(fuser.push(pen(159ms)));
}

TEST(Fuser, SettlesATipOnceReadingsSurroundIt)
{
    Fuser fuser(kRig);
    push_rise(fuser, 0ms, 100ms);
    auto const live = fuser.push(pen(108ms));
    EXPECT_TRUE(fuser.take_settled().empty());
    for (int i = 0; i < 15; ++i) // The carriage stops unexpectedly at 100 ms.
        fuser.push(height(103ms + i * 2ms, 100));
    auto const settled = fuser.take_settled();
    ASSERT_EQ(settled.size(), 1u);
    EXPECT_EQ(settled[0].height_source, TipSample::HeightSource::Interpolated);
    EXPECT_EQ(settled[0].time, live->time);
    EXPECT_LT(settled[0].position_mm.z(), 10);
    EXPECT_TRUE(fuser.take_settled().empty());
}

TEST(Fuser, SettlesTheRestAtTheEndOfALog)
{
    Fuser fuser(kRig);
    push_rise(fuser, 0ms, 101ms);
    for (auto time = 100ms; time <= 120ms; time += 5ms)
        (void)fuser.push(pen(time));
    fuser.flush();
    auto const settled = fuser.take_settled();
    ASSERT_EQ(settled.size(), 5u);
    EXPECT_EQ(settled.front().height_source, TipSample::HeightSource::Interpolated);
    EXPECT_EQ(settled.back().height_source, TipSample::HeightSource::Extrapolated);
    EXPECT_NEAR(settled.back().position_mm.z(), 10.5, 1e-9) << "carried on for 5 ms, then held";
}

TEST(Fuser, BreaksAStrokeWhereHeightsAreMissing)
{
    Fuser fuser(kRig);
    std::vector<TipSample> live;
    for (auto time = 0ms; time < 1000ms; time += 2ms) {
        if (time < 300ms || time > 600ms)
            fuser.push(height(time, 500));
        if (auto const tip = time % 10ms == 0ms ? fuser.push(pen(time)) : std::nullopt)
            live.push_back(*tip);
    }
    fuser.flush();
    for (auto const& tips : { live, fuser.take_settled() }) {
        ASSERT_GT(tips.size(), 60u);
        std::size_t lifted = 0;
        for (std::size_t i = 1; i < tips.size(); ++i) {
            bool const after_gap = tips[i].time - tips[i - 1].time > 10ms;
            EXPECT_EQ(tips[i].touching, !after_gap);
            lifted += after_gap;
        }
        EXPECT_EQ(lifted, 1u);
    }
    auto const& counts = fuser.counts();
    EXPECT_EQ(counts.pens, 100u);
    EXPECT_GT(counts.pens_without_height, 15u);
    EXPECT_EQ(counts.settled + counts.pens_without_height, counts.pens);
}

TEST(Fuser, GivesUpPensWhoseHeightsDoNotCome)
{
    Fuser fuser(kRig);
    for (auto time = 0ms; time < 100s; time += 5ms)
        (void)fuser.push(pen(time));
    EXPECT_GT(fuser.counts().pens_without_height, 19'700u);
    EXPECT_TRUE(fuser.take_settled().empty());
}

TEST(Fuser, DoesNotDependOnHowTheSensorsInterleave)
{
    Fuser pens_first(kRig);
    Fuser heights_first(kRig);
    for (auto time = 500ms; time < 900ms; time += 5ms)
        (void)pens_first.push(pen(time));
    push_rise(pens_first, 0ms, 1000ms);
    push_rise(heights_first, 0ms, 1000ms);
    for (auto time = 500ms; time < 900ms; time += 5ms)
        (void)heights_first.push(pen(time));
    auto const a = pens_first.take_settled();
    auto const b = heights_first.take_settled();
    ASSERT_EQ(a.size(), 80u);
    ASSERT_EQ(b.size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].position_mm, b[i].position_mm);
        EXPECT_EQ(a[i].time, b[i].time);
    }
}

TEST(Fuser, SurvivesHeightsLateTwiceAndBackwards)
{
    Fuser in_order(kRig);
    Fuser shuffled(kRig);
    push_rise(in_order, 0ms, 1000ms);
    for (auto block = 0ms; block < 1000ms;
         block += 10ms) // Each block of five readings is reversed, and its middle one repeated.
        for (auto late : { 8ms, 6ms, 4ms, 4ms, 2ms, 0ms })
            push_rise(shuffled, block + late, block + late + 2ms);
    EXPECT_EQ(in_order.push(pen(508ms))->position_mm, shuffled.push(pen(508ms))->position_mm);
    EXPECT_EQ(shuffled.counts().heights_refused, 0u);
}

TEST(Fuser, SurvivesAClockThatJumpsBack)
{
    Fuser fuser(kRig);
    for (auto start : { 100s, 0s }) {
        for (auto time = 0ms; time < 3000ms; time += 5ms) {
            fuser.push(height(start + time, 500));
            (void)fuser.push(pen(start + time));
        }
    }
    fuser.flush();
    EXPECT_GT(fuser.take_settled().size(), 590u);
    EXPECT_EQ(fuser.counts().settled + fuser.counts().pens_without_height, 1200u);
}

TEST(Fuser, RefusesReadingsThatAreNotTheRigs)
{
    Fuser fuser(kRig);
    fuser.push({ .time = at(1ms), .counts = 10, .full_scale = 1023 });
    fuser.push(height(2ms, -1));
    fuser.push(height(3ms, 4096));
    EXPECT_EQ(fuser.counts().heights_refused, 3u);
    EXPECT_FALSE(fuser.push(pen(10ms)));
}

TEST(Fuser, RefusesReadingsOutOfTheModelsReach)
{
    auto rig = kRig;
    rig.height_model = StringHeight { .mm_per_count = 0.1, .zero_length_mm = 0, .offset_mm = 100 };
    Fuser fuser(rig);
    fuser.push(height(1ms, 999));
    EXPECT_EQ(fuser.counts().heights_refused, 1u);
    fuser.push(height(3ms, 1001));
    EXPECT_EQ(fuser.counts().heights_refused, 1u);
}

TEST(Fuser, UsesAndCountsReadingsOutsideTheCalibratedRange)
{
    auto rig = kRig;
    rig.calibrated_max_counts = 3000;
    Fuser fuser(rig);
    fuser.push(height(3ms, 3001));
    EXPECT_EQ(fuser.counts().heights_uncalibrated, 1u);
    EXPECT_NEAR(fuser.push(pen(8ms))->position_mm.z(), 300.1, 1e-9);
}

TEST(Fuser, MarksTipsOutsideTheCalibratedRange)
{
    auto rig = kRig;
    rig.calibrated_min_counts = 1000; // This count is 100 mm.
    rig.calibrated_max_counts = 3000; // This count is 300 mm.
    struct Case {
        std::int32_t counts = 0;
        bool is_outside = false;
    };
    for (auto const& [counts, is_outside] :
         { Case { 980, true }, Case { 995, false }, Case { 2000, false }, Case { 3005, false },
           Case { 3020, true } }) {
        Fuser fuser(rig);
        fuser.push(height(3ms, counts));
        EXPECT_EQ(fuser.push(pen(8ms))->outside_calibration, is_outside) << counts;
        fuser.flush();
        EXPECT_EQ(fuser.take_settled().at(0).outside_calibration, is_outside) << counts;
        EXPECT_EQ(fuser.counts().settled_uncalibrated, is_outside ? 1u : 0u);
    }
}

TEST(Fuser, TakesASensorThatCountsDown)
{
    auto rig = kRig;
    rig.height_model = LinearHeight { .mm_per_count = -0.1, .zero_counts = 4000 };
    rig.calibrated_min_counts = 1000; // This count is 300 mm.
    rig.calibrated_max_counts = 3000; // This count is 100 mm.
    Fuser fuser(rig);
    fuser.push(height(3ms, 1500));
    auto const tip = fuser.push(pen(8ms));
    EXPECT_NEAR(tip->position_mm.z(), 250, 1e-9);
    EXPECT_FALSE(tip->outside_calibration);
    fuser.push(height(99ms, 500)); // The carriage has had enough time to reach 350 mm.
    EXPECT_TRUE(fuser.push(pen(106ms))->outside_calibration);
}

TEST(Fuser, TakesThePressureThatTheTabletMeasures)
{
    Fuser fuser(kRig);
    fuser.push(height(0ms, 0));
    auto sample = pen(1ms);
    sample.pressure = 0.25;
    EXPECT_EQ(fuser.push(sample)->pressure, 0.25);
}

TEST(Fuser, PressesFullyWhileTouchingWhereTheTabletMeasuresNone)
{
    Fuser fuser(kRig);
    fuser.push(height(0ms, 0));
    auto sample = pen(1ms);
    EXPECT_EQ(fuser.push(sample)->pressure, 1);
    sample.touching = false;
    EXPECT_EQ(fuser.push(sample)->pressure, 0);
}

TEST(Fuser, KeepsTheEraserAndTheLiftedPen)
{
    Fuser fuser(kRig);
    fuser.push(height(0ms, 0));
    auto sample = pen(1ms);
    sample.eraser = true;
    EXPECT_TRUE(fuser.push(sample)->eraser);
    sample.touching = sample.in_range = false;
    auto const tip = fuser.push(sample);
    ASSERT_TRUE(tip);
    EXPECT_FALSE(tip->touching);
}

TEST(Fuser, TakesHeightsFromAScenarioWhereThereIsNoSensor)
{
    ScriptedHeight const rise { .scenario = { .kind = HeightScenario::Kind::Rise },
                                .first_pen = at(1s),
                                .last_pen = at(11s) };
    Fuser fuser(kRig, rise);
    fuser.push(height(6s, 4000));
    auto const live = fuser.push(pen(6s));
    ASSERT_TRUE(live);
    EXPECT_DOUBLE_EQ(live->position_mm.z(), 200);
    EXPECT_EQ(live->height_source, TipSample::HeightSource::Interpolated);
    auto const settled = fuser.take_settled();
    ASSERT_EQ(settled.size(), 1u);
    EXPECT_EQ(settled[0].position_mm, live->position_mm);
}

// Returns the tips' errors for a carriage that rises at 100 mm a second and a pen whose position
// shows its time, with samples that arrive in bursts every 30 ms.
std::vector<double> errors_in_bursts_mm(SampleTimes sample_times)
{
    auto rig = kRig;
    rig.height_latency = rig.tablet_latency = 0ms;
    rig.sample_times = sample_times;
    Fuser fuser(rig);
    auto next_pen = 0us;
    auto next_height = 700us;
    std::vector<double> errors_mm;
    for (Duration burst = 30ms; burst < 3s; burst += 30ms) {
        for (; next_height < burst; next_height += 1970us)
            fuser.push(height(burst, static_cast<int>(next_height / 1ms)));
        // The pen's position encodes its time: 10 mm per second.
        for (; next_pen < burst; next_pen += 7310us)
            (void)fuser.push(pen(burst, { to_seconds(next_pen) * 10, 0 }));
    }
    fuser.flush();
    for (auto const& tip : fuser.take_settled()) {
        double const taken_s = (tip.position_mm.x() + rig.tablet_size_mm.x() / 2) / 10;
        if (taken_s > 1)
            errors_mm.push_back(tip.position_mm.z() - 100 * taken_s);
    }
    return errors_mm;
}

TEST(Fuser, PutsBurstsOfBothSensorsOneAfterTheOther)
{
    auto const evened_mm = errors_in_bursts_mm(SampleTimes::Evened);
    ASSERT_GT(evened_mm.size(), 200u);
    for (double const error_mm : evened_mm)
        EXPECT_LT(std::abs(error_mm), 0.2);
    double most_mm = 0;
    for (double const error_mm : errors_in_bursts_mm(SampleTimes::AsArrived))
        most_mm = std::max(most_mm, std::abs(error_mm));
    EXPECT_GT(most_mm, 1) << "or there is nothing to even out";
}

} // namespace
} // namespace tractus::calib
