#include "calib/height_monitor.h"

#include "sim/simulated_rig.h"
#include "tests/sim/fused_run.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

using enum HeightFaultKind;
using std::chrono::milliseconds;
using std::chrono::seconds;

// Rig with 0.1 mm per count and 12 bits.
Rig const kPlainRig;

Timestamp moment(Duration time)
{
    return Timestamp(time);
}

// Pushes a reading every 2 ms, from `begin` until just before `end`.
template<typename Counts>
void push(HeightMonitor& monitor, Duration begin, Duration end, Counts const& counts)
{
    int index = 0;
    for (auto time = begin; time < end; time += milliseconds(2))
        monitor.push({ .time = moment(time), .counts = counts(index++), .full_scale = 4095 });
}

int flickering(int index)
{
    return 1000 + index % 3;
}

int still(int)
{
    return 1000;
}

void expect_no_fault(HeightMonitor const& monitor)
{
    EXPECT_FALSE(monitor.present());
    EXPECT_EQ(describe_faults(monitor, {}), std::vector<std::string>());
}

TEST(HeightMonitor, FindsNoFaultInAHealthySensor)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(20), flickering);
    expect_no_fault(monitor);
    EXPECT_NEAR(monitor.rate_hz(), 500, 0.1);
}

// Returns readings of a surface that rises at 100 mm/s while the string slips within 20 ms.
int rising_with_slip(int index, double slip_mm)
{
    double const time_s = index * 0.002;
    double const slipped = std::clamp((time_s - 0.5) / 0.02, 0.0, 1.0);
    return static_cast<int>(std::lround(1000 + 10 * (100 * time_s - slip_mm * slipped)));
}

TEST(HeightMonitor, SeesASlowSlipInTheMidstOfAMovement)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), milliseconds(700), [](int i) { return rising_with_slip(i, 6); });
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->kind, Jump);
    EXPECT_EQ(describe_fault(*monitor.present()),
              "height stepped by -6 mm: has the string slipped? then zero it");
    EXPECT_EQ(describe_faults(monitor, {}),
              std::vector<std::string> { "the height stepped once, by -6.0 mm at 0.5 s, more "
                                         "abruptly than a hand: if the string slipped, zero it "
                                         "with \"tractus calibrate zero\"" });
}

TEST(HeightMonitor, TakesNoSmallStepForASlip)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), milliseconds(700), [](int i) { return rising_with_slip(i, 2); });
    expect_no_fault(monitor);
}

TEST(HeightMonitor, TakesTheBeginningOfAMovementForNoSlip)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1),
         // The movement begins abruptly, at 300 mm/s.
         [](int i) { return 1000 + std::max(0, i - 250) * 6; });
    expect_no_fault(monitor);
}

TEST(HeightMonitor, TellsThatNothingComesAnyMore)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1), flickering);
    monitor.advance(moment(milliseconds(1200)));
    EXPECT_FALSE(monitor.present()) << "a fifth of a second may be the computer's fault";
    monitor.advance(moment(milliseconds(3198)));
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->kind, Silence);
    EXPECT_EQ(monitor.present()->begin, moment(milliseconds(998)));
    EXPECT_EQ(describe_fault(*monitor.present()),
              "height sensor silent for 2 s: is it plugged in?");
}

TEST(HeightMonitor, TellsThatNothingEverCame)
{
    HeightMonitor monitor(kPlainRig);
    monitor.advance(moment(seconds(100)));
    monitor.advance(moment(seconds(101)));
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->begin, moment(seconds(100)));
}

TEST(HeightMonitor, ForgivesSilenceWhenReadingsComeAgain)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1), flickering);
    push(monitor, seconds(4), seconds(5), flickering);
    EXPECT_FALSE(monitor.present());
    EXPECT_EQ(describe_faults(monitor, moment({})),
              std::vector<std::string>({ "the height sensor fell silent once, for 3.0 s at 1.0 s: "
                                         "check its plug and its cable" }));
}

TEST(HeightMonitor, TellsOfReadingsAtEitherEnd)
{
    for (int const rail : { 0, 4, 4091, 4095 }) {
        HeightMonitor monitor(kPlainRig);
        push(monitor, seconds(0), seconds(1), flickering);
        push(monitor, seconds(1), seconds(2), [&](int) { return rail; });
        ASSERT_TRUE(monitor.present()) << rail;
        EXPECT_EQ(monitor.present()->kind, Rail);
        EXPECT_EQ(monitor.present()->begin, moment(seconds(1)));
        EXPECT_EQ(monitor.present()->counts, rail);
        EXPECT_EQ(monitor.total(Jump).count, 0U) << "the way there is the same fault";
    }
}

TEST(HeightMonitor, TakesASingleReadingAtAnEndForASpike)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(2), [](int i) { return i % 100 == 50 ? 0 : flickering(i); });
    expect_no_fault(monitor);
}

TEST(HeightMonitor, TellsOfAJumpThatNoHandMakes)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1), flickering);
    push(monitor, seconds(1), milliseconds(1100), [](int i) { return 300 + flickering(i); });
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->kind, Jump);
    EXPECT_EQ(monitor.present()->begin, moment(seconds(1)));
    EXPECT_NEAR(monitor.present()->speed_mm_per_s, 30 / 0.0025, 100);
    push(monitor, milliseconds(1100), seconds(2), [](int i) { return 300 + flickering(i); });
    EXPECT_FALSE(monitor.present());
    EXPECT_EQ(monitor.total(Jump).count, 1U);
}

TEST(HeightMonitor, CountsASpikeOnce)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(2), [](int i) { return i == 400 ? 2000 : flickering(i); });
    EXPECT_EQ(monitor.total(Jump).count, 1U);
}

TEST(HeightMonitor, LetsAHandMoveAsFastAsItCan)
{
    HeightMonitor monitor(kPlainRig);
    // A speed of 1.9 m/s is 38 counts in 2 ms.
    push(monitor, seconds(0), milliseconds(200), [](int i) { return 100 + 38 * i; });
    expect_no_fault(monitor);
}

TEST(HeightMonitor, DoesNotTakeABurstForAJump)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), milliseconds(100), [](int i) { return 1000 + 10 * i; });
    // Readings that were delayed by 50 ms arrive 50 us apart. The surface moves at 0.5 m/s.
    auto time = milliseconds(150);
    for (int i = 0; i < 25; ++i)
        monitor.push({ .time = moment(time + i * std::chrono::microseconds(50)),
                       .counts = 1500 + 10 * i,
                       .full_scale = 4095 });
    expect_no_fault(monitor);
}

TEST(HeightMonitor, TellsThatANoisySensorStandsStill)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1), flickering);
    push(monitor, seconds(1), seconds(7), still);
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->kind, Stuck);
    EXPECT_EQ(monitor.present()->begin, moment(seconds(1)));
    push(monitor, seconds(7), seconds(8), flickering);
    EXPECT_FALSE(monitor.present());
    EXPECT_EQ(describe_faults(monitor, {}).size(), 1U);
}

TEST(HeightMonitor, HasPatienceWithASensorThatNeverFlickers)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(0), seconds(1), [](int i) { return i; });
    push(monitor, seconds(1), seconds(59), still);
    EXPECT_FALSE(monitor.present());
    push(monitor, seconds(59), seconds(62), still);
    ASSERT_TRUE(monitor.present());
    EXPECT_EQ(monitor.present()->kind, Stuck);
}

TEST(HeightMonitor, AddsUpWhatHappenedSeveralTimes)
{
    HeightMonitor monitor(kPlainRig);
    push(monitor, seconds(10), seconds(11), flickering);
    push(monitor, seconds(12), seconds(13), flickering);
    push(monitor, seconds(15), seconds(16), flickering);
    EXPECT_EQ(describe_faults(monitor, moment(seconds(10))),
              std::vector<std::string>({ "the height sensor fell silent 2 times, for 3.0 s in all, "
                                         "the longest at 3.0 s: check its plug and its cable" }));
}

// Returns a monitor that has seen the reports of the simulated height sensor.
HeightMonitor watch(sim::SimulatedRun const& run)
{
    HeightMonitor monitor(run.rig);
    for (auto const& report : run.height.reports) {
        auto const byte = [&](std::size_t i) { return std::to_integer<int>(report.storage[i]); };
        monitor.push({ .time = report.received,
                       .counts = byte(1) | byte(2) << 8,
                       .full_scale = run.rig.full_scale_counts });
    }
    return monitor;
}

TEST(HeightMonitor, FindsNoFaultWhileASimulatedHandDraws)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        expect_no_fault(watch(sim::simulate_rig(sim::fast_hand(seed), { .seed = seed })));
}

TEST(HeightMonitor, FindsExactlyTheFaultsThatWereSimulated)
{
    auto const hand = sim::fast_hand(1);
    sim::SimulatedHeightFault const faults[] {
        { .kind = Silence, .begin = moment(seconds(1)), .end = moment(milliseconds(1600)) },
        { .kind = Rail,
          .begin = moment(seconds(1)),
          .end = moment(milliseconds(1100)),
          .counts = 4095 },
        { .kind = Rail,
          .begin = moment(seconds(1)),
          .end = moment(milliseconds(1100)),
          .counts = 0 },
        { .kind = Jump,
          .begin = moment(seconds(1)),
          .end = moment(milliseconds(1100)),
          .counts = 150 },
        { .kind = Stuck, .begin = moment(seconds(1)), .end = moment(milliseconds(6500)) },
    };
    for (auto const& fault : faults) {
        sim::SimulatedRigOptions options;
        options.height.faults = { fault };
        auto const monitor = watch(sim::simulate_rig(hand, options));
        ASSERT_GT(hand.end(), fault.end);
        auto const found = monitor.total(fault.kind);
        EXPECT_EQ(found.count, 1U) << describe_fault({ .kind = fault.kind });
        // Tolerance for a latency of 3 ms and a reading interval of 2 ms.
        auto const near = milliseconds(8);
        EXPECT_LE(found.worst.begin, fault.begin + near);
        EXPECT_GE(found.worst.begin, fault.begin - near);
        EXPECT_GE(found.worst.end, fault.kind == Jump ? fault.begin : fault.end - near);
        for (auto const other : { Silence, Rail, Jump, Stuck }) {
            // A stuck string that comes loose after the hand has moved causes a jump.
            bool const may_be = other == fault.kind || (fault.kind == Stuck && other == Jump);
            EXPECT_TRUE(may_be || monitor.total(other).count == 0);
        }
    }
}

} // namespace
} // namespace tractus::calib
