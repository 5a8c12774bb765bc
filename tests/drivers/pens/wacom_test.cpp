#include "drivers/pens/family_decoder.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/decode_one.h"

#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace tractus::drivers {
namespace {

// A tablet whose reports have the format of `family`, 200 x 100 mm with 100 counts per millimetre.
class Tablet {
public:
    explicit Tablet(std::string_view family, std::int32_t pressure_maximum = 2047)
        : decoder_(make_family_decoder(*find_pen_family(family),
                                       { .size_mm = { 200, 100 },
                                         .x_maximum = 20'000,
                                         .y_maximum = 10'000,
                                         .pressure_maximum = pressure_maximum }))
    {
    }

    std::vector<PenSample> report_at(Timestamp received, std::string const& text)
    {
        std::vector<PenSample> samples;
        EXPECT_TRUE(decoder_->decode(received, bytes(text), samples));
        return samples;
    }

    std::optional<PenSample> report(std::string const& text)
    {
        return decode_one(*decoder_, {}, bytes(text)).value();
    }

    std::optional<PenSample> leave(Timestamp time) { return decoder_->leave(time); }

    // Returns the sample of a report that must give one.
    PenSample sample(std::string const& text)
    {
        auto const result = report(text);
        EXPECT_TRUE(result) << text;
        return result.value_or(PenSample());
    }

private:
    std::unique_ptr<PenDecoder> decoder_;
};

TEST(Wacom, FamiliesHaveNamesOfTheirOwn)
{
    std::set<std::string_view> names;
    for (auto const& family : pen_families()) {
        EXPECT_TRUE(family.decode) << family.name;
        EXPECT_TRUE(names.insert(family.name).second) << family.name;
        EXPECT_EQ(find_pen_family(family.name)->name, family.name);
    }
    EXPECT_EQ(find_pen_family("no such family"), nullptr);
}

TEST(Wacom, FamiliesPassOverShortReports)
{
    for (auto const& family : pen_families())
        for (auto const* text : { "02", "10 20", "1e 01 40", "1f", "02 e0 00 00" }) {
            FamilyState state;
            EXPECT_FALSE(family.decode(bytes(text), state)) << family.name << ' ' << text;
        }
}

// Returns a Bluetooth report: frames from its second byte on, and the pen's serial number at
// `serial_at`.
std::string bluetooth_report(std::vector<std::string> const& frames, std::size_t serial_at)
{
    std::string report = "80";
    for (auto const& frame : frames)
        report += ' ' + frame;
    while (report.size() < 3 * serial_at - 1)
        report += " 00";
    report += " 78 56 34 12";
    while (report.size() < 3 * 361 - 1)
        report += " 00";
    return report;
}

TEST(Wacom, TakesEveryFrameOfAReportOverBluetooth)
{
    Tablet pro("wacom-intuos-pro-bluetooth", 8191);
    auto const both
        = pro.report_at({},
                        bluetooth_report({ "e1 64 00 c8 00 ff 0f 05 fb 00 00 00 00 08",
                                           "e3 d0 07 e8 03 ff 1f 05 fb 00 00 00 00 08" },
                                         99));
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].raw_x, 100);
    EXPECT_EQ(both[0].buttons, 0u);
    auto const& drawing = both[1];
    EXPECT_EQ(drawing.raw_x, 2000);
    EXPECT_EQ(drawing.raw_y, 1000);
    EXPECT_EQ(drawing.pressure, 1.0);
    EXPECT_TRUE(drawing.touching);
    EXPECT_FALSE(drawing.eraser);
    EXPECT_EQ(drawing.buttons, 1u);
    ASSERT_TRUE(drawing.tilt_rad);
    EXPECT_NEAR(drawing.tilt_rad->x(), 5 * std::numbers::pi / 180, 1e-9);
    EXPECT_FALSE(pro.report(bluetooth_report({}, 99))); // All frames are empty.
    EXPECT_FALSE(pro.sample(bluetooth_report({ "80 00 00 00 00 00 00" }, 99)).in_range);

    Tablet small("wacom-intuos-bluetooth", 4095);
    auto const erasing = small.sample(bluetooth_report({ "f1 d0 07 e8 03 ff 07 04" }, 33));
    EXPECT_EQ(erasing.raw_x, 2000);
    EXPECT_TRUE(erasing.eraser);
    EXPECT_TRUE(erasing.touching);
    EXPECT_FALSE(erasing.tilt_rad);
}

TEST(Wacom, TakesNoFingersForAPen)
{
    // Reports of fingers have the report id of the pen, but are longer.
    auto const fingers = std::string("02 e1 13 88 04 e2 40 eb 64 02 00 00 00 00 00 00 00 00 00 00");
    for (auto const* family : { "wacom-intuos", "wacom-intuos-pro" })
        EXPECT_EQ(Tablet(family).report(fingers), std::nullopt) << family;
}

TEST(Wacom, GraphireReadsItsPen)
{
    Tablet tablet("wacom-graphire", 511);
    auto const pen = tablet.sample("02 91 10 27 c4 09 ff 01");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.pressure, 1.0);
    EXPECT_TRUE(pen.touching);
    EXPECT_NEAR(pen.position_mm.x(), 100, 1e-9);
    EXPECT_NEAR(pen.position_mm.y(), 75, 1e-9);
    EXPECT_EQ(tablet.sample("02 96 10 27 c4 09 00 00").buttons, 3u);
    EXPECT_FALSE(tablet.sample("02 10 00 00 00 00 00 00").in_range);
}

TEST(Wacom, GraphireTellsTheEraserAndTheMouse)
{
    Tablet tablet("wacom-graphire", 511);
    auto const eraser = tablet.sample("02 b1 10 27 c4 09 40 00");
    EXPECT_TRUE(eraser.eraser && eraser.touching);
    EXPECT_FALSE(tablet.sample("02 d0 10 27 c4 09 00 00").in_range); // A mouse, which is not a pen.
    EXPECT_EQ(tablet.report("02 d1 10 28 c4 09 00 00"), std::nullopt);
}

TEST(Wacom, GraphirePadReportsSayNothingOfThePen)
{
    Tablet tablet("wacom-graphire", 511);
    EXPECT_EQ(tablet.report("02 00 00 00 00 00 00 c3"), std::nullopt);
    EXPECT_EQ(tablet.report("63 00 00 00 00 00 00 00"), std::nullopt);
}

TEST(Wacom, IntuosReadsItsPen)
{
    Tablet tablet("wacom-intuos", 1023);
    auto const pen = tablet.sample("02 f3 10 27 c4 09 ff 03 05");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.pressure, 1.0);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_FALSE(tablet.sample("02 80 00 00 00 00 00 00 00").in_range);
    auto const eraser = tablet.sample("02 f8 10 27 c4 09 00 00 05");
    EXPECT_TRUE(eraser.eraser && !eraser.touching);
}

TEST(Wacom, IntuosLeavesWhereItsPlaceIsNoLongerSure)
{
    Tablet tablet("wacom-intuos");
    tablet.sample("02 f0 10 27 c4 09 00 00 02");
    EXPECT_FALSE(tablet.sample("02 d0 0d 15 7e 10 00 00 00").in_range);
}

TEST(Wacom, IntuosProReadsPlacePressureAndTilt)
{
    Tablet tablet("wacom-intuos-pro");
    EXPECT_EQ(tablet.report("02 c2 80 22 38 0a 9a 91 00 00"), std::nullopt);
    // X 0x1388 << 1 | 1, Y 0x04e2 << 1, pressure 0x40 << 3 | 3 << 1 | 1, tilts of 22 and 36
    // degrees.
    auto const pen = tablet.sample("02 e1 13 88 04 e2 40 eb 64 02");
    EXPECT_EQ(pen.raw_x, 10'001);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 519);
    EXPECT_TRUE(pen.touching);
    EXPECT_FALSE(pen.eraser);
    ASSERT_TRUE(pen.tilt_rad);
    EXPECT_NEAR(pen.tilt_rad->x(), radians(22.0), 1e-12);
    EXPECT_NEAR(pen.tilt_rad->y(), radians(-36.0), 1e-12); // Tilted away from the user.
}

TEST(Wacom, IntuosProTellsItsPensApart)
{
    Tablet tablet("wacom-intuos-pro");
    tablet.report("02 c2 80 22 38 0a 9a 91 00 00");
    auto const pen = tablet.sample("02 e0 13 88 04 e2 00 2b 64 00");
    EXPECT_EQ(pen.tool_serial, 0x2380a9a9u);
    EXPECT_EQ(pen.tool_type, 0x10802u);
    EXPECT_FALSE(tablet.sample("02 80 00 00 00 00 00 00 00 00").in_range);
    tablet.report("02 c2 80 a2 38 0a 9a 91 00 00");
    EXPECT_TRUE(tablet.sample("02 e0 13 88 04 e2 00 2b 64 00").eraser);
}

TEST(Wacom, IntuosProKeepsThePressureWhileAnArtPenTurns)
{
    Tablet tablet("wacom-intuos-pro");
    tablet.report("02 c2 80 42 48 0d e2 11 00 00");
    auto const pressing = tablet.sample("02 e2 13 88 04 e2 40 2b 64 00");
    auto const turning = tablet.sample("02 ea 13 89 04 e2 7f c0 00 00");
    EXPECT_EQ(turning.raw_x, 10'002);
    EXPECT_EQ(turning.raw_pressure, pressing.raw_pressure);
    EXPECT_EQ(turning.tilt_rad, pressing.tilt_rad);
    EXPECT_EQ(turning.buttons, 1u);
    EXPECT_TRUE(turning.touching);
}

TEST(Wacom, IntuosProIsAwayWhileItsPenIsTooHigh)
{
    Tablet tablet("wacom-intuos-pro");
    tablet.sample("02 e0 13 88 04 e2 00 2b 64 00");
    EXPECT_FALSE(tablet.sample("02 20 18 c3 00 00 00 00 00 fc").in_range);
    EXPECT_EQ(tablet.report("02 2a 18 c3 00 00 00 00 00 fc"), std::nullopt);
    EXPECT_TRUE(tablet.sample("02 e0 13 88 04 e2 00 2b 64 00").in_range);
}

TEST(Wacom, IntuosProDrawsToItsRightEdge)
{
    // X is at its maximum of 20,000 (27 10, doubled), and the pressure is 226 * 8. The near bit,
    // 0x40, is clear, but the pen still draws.
    Tablet tablet("wacom-intuos-pro");
    EXPECT_TRUE(tablet.sample("02 e0 26 ac 04 e2 e2 2b 64 00").touching);
    auto const at_edge = tablet.sample("02 a0 27 10 04 e2 e2 2b 64 00");
    EXPECT_TRUE(at_edge.touching);
    EXPECT_EQ(at_edge.raw_x, 20'000);
    EXPECT_EQ(at_edge.raw_pressure, 226 * 8);
    // A pressure of 8 is noise.
    EXPECT_FALSE(tablet.sample("02 a0 27 10 04 e2 01 00 64 00").in_range);
}

TEST(Wacom, IntuosProIsAwayWherePressureAloneSpeaksForIt)
{
    Tablet tablet("wacom-intuos-pro");
    tablet.sample("02 e0 26 ac 04 e2 e2 2b 64 00");
    // The pen is not at the right edge, so the near bit counts.
    EXPECT_FALSE(tablet.sample("02 a0 27 0f 04 e2 e2 2b 64 00").in_range);
}

TEST(Wacom, IntuosProTakesNoMouseForAPen)
{
    Tablet tablet("wacom-intuos-pro");
    for (auto const* mouse : { "02 f0 13 88 04 e2 00 00 00 00", "02 ec 13 88 04 e2 00 20 53 3d",
                               "02 ea 13 88 04 e2 00 20 53 3d" /* A mouse's second report. */,
                               "0c 00 00 00 00 00 00 00 00 00" })
        EXPECT_EQ(tablet.report(mouse), std::nullopt) << mouse;
}

TEST(Wacom, IntuosV2ReadsWideAxes)
{
    Tablet tablet("wacom-intuos-v2", 8191);
    auto const pen = tablet.sample("10 63 10 27 00 c4 09 00 ff 1f 1e e2 00 00 00 00 10");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.pressure, 1.0);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_NEAR(pen.tilt_rad.value().x(), radians(30.0), 1e-12);
    EXPECT_NEAR(pen.tilt_rad.value().y(), radians(30.0), 1e-12);
    EXPECT_FALSE(tablet.sample("10 00 00 00 00 00 00 00 00 00 00 00 00").in_range);
    EXPECT_TRUE(tablet.sample("10 70 10 27 00 c4 09 00 00 00 00 00 00").eraser);
    EXPECT_FALSE(tablet.sample("10 00 00 00 00 00 00 00 00 00 00 00 00").in_range);
    EXPECT_EQ(tablet.report("11 01 00 00 00 00 00 00 00 00 00 00 00"), std::nullopt);
}

TEST(Wacom, IntuosV2ReadsItsShiftedReports)
{
    Tablet tablet("wacom-intuos-v2", 8191);
    auto const pen = tablet.sample("1e 01 69 10 27 00 c4 09 00 ff 1f 1e e2");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 8191);
    EXPECT_EQ(pen.buttons, 4u);
    EXPECT_NEAR(pen.tilt_rad.value().x(), radians(30.0), 1e-12);
}

TEST(Wacom, IntuosV3ReadsLongReports)
{
    Tablet tablet("wacom-intuos-v3", 8191);
    auto const pen = tablet.sample("1e 01 c3 10 27 00 c4 09 00 ff 1f 1e 00 e2 ff");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 8191);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_NEAR(pen.tilt_rad.value().x(), radians(30.0), 1e-12);
    EXPECT_NEAR(pen.tilt_rad.value().y(), radians(30.0), 1e-12);
    EXPECT_FALSE(tablet.sample("1e 01 80 00 00 00 00 00 00 00 00 00 00 00 00").in_range);
    EXPECT_TRUE(tablet.sample("1e 01 60 10 27 00 c4 09 00 00 00 00 00 00 00").eraser);
}

TEST(Wacom, IntuosV3ReadsShortReports)
{
    Tablet tablet("wacom-intuos-v3", 8191);
    auto const pen = tablet.sample("1f 01 48 10 27 c4 09 ff 1f 1e 00 e2 00 00 00");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 8191);
    EXPECT_EQ(pen.buttons, 4u);
    EXPECT_NEAR(pen.tilt_rad.value().y(), radians(30.0), 1e-12);
    EXPECT_EQ(tablet.report("1f 02 48 10 27 c4 09 ff 1f 1e 00 e2 00 00 00"), std::nullopt);
}

TEST(Wacom, DtuReadsItsPen)
{
    Tablet tablet("wacom-dtu", 511);
    auto const pen = tablet.sample("02 21 10 27 c4 09 ff 01");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.pressure, 1.0);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(tablet.sample("02 32 10 27 c4 09 00 00").buttons, 3u);
    EXPECT_FALSE(tablet.sample("02 00 10 27 c4 09 00 00").in_range);
    auto const eraser = tablet.sample("02 24 10 27 c4 09 40 00");
    EXPECT_TRUE(eraser.eraser && eraser.touching);
}

TEST(Wacom, FramesOverBluetoothLieBetweenTheirReports)
{
    using namespace std::chrono_literals;
    std::string const frame = "e1 64 00 c8 00 ff 0f 05 fb 00 00 00 00 08";
    Tablet tablet("wacom-intuos-pro-bluetooth", 8191);
    std::vector<PenSample> all;
    auto const report = [&](Duration received, std::vector<std::string> const& frames) {
        auto const some = tablet.report_at(Timestamp(received), bluetooth_report(frames, 99));
        all.insert(all.end(), some.begin(), some.end());
    };
    report(100ms, { frame, frame, frame });
    report(112ms, { frame, frame, frame, frame }); // Too soon for the samples to be 5 ms apart.
    report(300ms, { frame, frame });               // Long after the previous report.
    // Two reports: one at the time of the previous report, and one before it.
    report(300ms, { frame, frame });
    report(290ms, { frame });
    // Empty frames at the beginning and in between.
    report(400ms,
           { "00 00 00 00 00 00 00 00 00 00 00 00 00 00", frame,
             "00 00 00 00 00 00 00 00 00 00 00 00 00 00", frame });
    std::vector<Duration> times;
    for (auto const& sample : all)
        times.push_back(sample.time.time_since_epoch());
    EXPECT_EQ(times,
              (std::vector<Duration> { 90ms, 95ms, 100ms, 103ms, 106ms, 109ms, 112ms, 295ms, 300ms,
                                       300ms, 300ms, 290ms, 395ms, 400ms }));
}

TEST(Wacom, FramesOverBluetoothAreNotOlderThanThePensLeaving)
{
    using namespace std::chrono_literals;
    std::string const frame = "e1 64 00 c8 00 ff 0f 05 fb 00 00 00 00 08";
    Tablet tablet("wacom-intuos-pro-bluetooth", 8191);
    tablet.report_at(Timestamp(100ms), bluetooth_report({ frame }, 99));
    ASSERT_TRUE(tablet.leave(Timestamp(250ms)));
    auto const back
        = tablet.report_at(Timestamp(256ms), bluetooth_report({ frame, frame, frame }, 99));
    ASSERT_EQ(back.size(), 3U);
    EXPECT_EQ(back[0].time, Timestamp(252ms));
    EXPECT_EQ(back[2].time, Timestamp(256ms));
}

TEST(Wacom, GraphireReadsItsPenOverBluetooth)
{
    // X 2,000 (07d0) and Y 1,000 (03e8), low byte first; pressure 256 (bit 3 of the flags) + 4.
    Tablet tablet("wacom-graphire-bluetooth", 511);
    auto const pen = tablet.sample("03 8b d0 07 e8 03 04 00");
    EXPECT_EQ(pen.raw_x, 2000);
    EXPECT_EQ(pen.raw_y, 1000);
    EXPECT_EQ(pen.raw_pressure, 260);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_FALSE(tablet.sample("03 00 00 00 00 00 00 00").in_range);
    EXPECT_TRUE(tablet.sample("03 a0 d0 07 e8 03 00 00").eraser);
    // A mouse on the tablet, which is not a pen.
    EXPECT_FALSE(tablet.sample("03 c0 d0 07 e8 03 00 00").in_range);
    EXPECT_EQ(tablet.report("02 81 d0 07 e8 03 04 00"), std::nullopt);
}

TEST(Wacom, DtusReadsItsPen)
{
    // Flags: 0x80 in range, 0x10 pen, 0x20 first button, 0x01 high bits of the pressure: 256 + 44.
    // X 2,000 and Y 1,000, high byte first.
    Tablet tablet("wacom-dtus", 511);
    auto const pen = tablet.sample("11 b1 2c 07 d0 03 e8 00");
    EXPECT_EQ(pen.raw_x, 2000);
    EXPECT_EQ(pen.raw_y, 1000);
    EXPECT_EQ(pen.raw_pressure, 300);
    EXPECT_TRUE(pen.touching);
    EXPECT_FALSE(pen.eraser);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_FALSE(tablet.sample("11 90 0a 07 d0 03 e8 00").touching); // A pressure of 10 is noise.
    EXPECT_FALSE(tablet.sample("11 00 00 00 00 00 00 00").in_range);
    EXPECT_TRUE(tablet.sample("11 88 40 07 d0 03 e8 00").eraser);
    // A report of the tablet's keys.
    EXPECT_EQ(tablet.report("15 01 00 00 00 00 00 00"), std::nullopt);
}

TEST(Wacom, PlReadsItsSevenBitBytes)
{
    Tablet tablet("wacom-pl", 511);
    // X = 0 << 14 | 0x4e << 7 | 0x10, Y = 0x13 << 7 | 0x44, pressure 0x3f << 2 | 2 | 1.
    auto const pen = tablet.sample("02 40 4e 10 5c 13 44 7f");
    EXPECT_EQ(pen.raw_x, 10'000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 255);
    EXPECT_TRUE(pen.touching);
    EXPECT_EQ(pen.buttons, 1u);
    EXPECT_FALSE(tablet.sample("02 00 00 00 00 00 00 00").in_range);
}

TEST(Wacom, PlTakesThePenForTheEraserIfItComesWithTheBit)
{
    Tablet tablet("wacom-pl", 511);
    EXPECT_FALSE(tablet.sample("02 40 4e 10 00 13 44 40").eraser);
    // Here the bit is the pen's second button.
    EXPECT_EQ(tablet.sample("02 40 4e 10 20 13 44 40").buttons, 2u);
    tablet.sample("02 00 00 00 00 00 00 00");
    auto const eraser = tablet.sample("02 40 4e 10 28 13 44 7f");
    EXPECT_TRUE(eraser.eraser && eraser.touching);
    EXPECT_EQ(eraser.buttons, 0u);
}

TEST(Wacom, ReadsTheSameBehindAnotherSystemsByte)
{
    Tablet plain("wacom-intuos-pro");
    Tablet shifted("wacom-driver-intuos-pro");
    auto const report = std::string("02 e1 13 88 04 e2 40 eb 64 02");
    EXPECT_EQ(shifted.sample("c0 " + report).position_mm, plain.sample(report).position_mm);
    EXPECT_EQ(shifted.report("c0"), std::nullopt);
}

} // namespace
} // namespace tractus::drivers
