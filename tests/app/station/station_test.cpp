#include "app/station/station.h"

#include "app/methods/all_methods.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "tests/app/drawing_station.h"
#include "tests/app/simple_rig.h"
#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus::station {
namespace {

// Returns a station without a height sensor, whose surface is always at 100 mm.
DrawingStation low_station(std::optional<tools::Tool> const& tool = {})
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    options.scripted_height = calib::ScriptedHeight {
        .scenario = { .kind = calib::HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    options.tool = tool;
    return DrawingStation(Station::create(simple_rig(), options).value(), small_scene());
}

TEST(Station, KnowsWhatThePenReaches)
{
    auto const volume = low_station().volume_mm();
    EXPECT_LT((volume.min_mm - Vec3(-100, -50, 0)).norm(), 1e-9);
    EXPECT_LT((volume.max_mm - Vec3(100, 50, 300)).norm(), 1e-9);
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig = { .height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = 500 },
                    .calibrated_min_counts = 700,
                    .calibrated_max_counts = 3500,
                    .tablet_size_mm = { 200, 100 },
                    .rotation_deg = 90 };
    auto const turned = Station::create(simple_rig(), options).value().volume_mm();
    EXPECT_LT((turned.min_mm - Vec3(-50, -100, 20)).norm(), 1e-9);
    EXPECT_LT((turned.max_mm - Vec3(50, 100, 300)).norm(), 1e-9);
}

TEST(Station, MakesAStrokeOfWhatThePenTouches)
{
    auto station = low_station();
    draw_across(station, 0);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    auto const& tips = station.strokes()[0].stroke.tips;
    EXPECT_NEAR((tips.front().position_mm - Vec3(-50, 0, 100)).norm(), 0, 0.1);
    EXPECT_NEAR((tips.back().position_mm - Vec3(45, 0, 100)).norm(), 0, 5.1);
    EXPECT_EQ(station.scene().associations.size(), 1u);
    EXPECT_EQ(station.counts().strokes, 1u);
    EXPECT_EQ(station.counts().pen_samples, 21u);
}

TEST(Station, ScalesAPenThatDoesNotTellItsSizeToTheMeasuredSurface)
{
    // A tablet whose two axes both range to 32767, and which states no size.
    drivers::DeviceInfo const pen {
        .name = "Tablet",
        .vendor_id = 0x1234,
        .product_id = 0x5678,
        .report_descriptor
        = drivers::bytes("05 0d 09 02 a1 01 09 20 a1 00 09 42 15 00 25 01 75 01 95 01 81 "
                         "02 95 07 81 03 05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 c0 "
                         "c0"),
    };
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    options.rig.surface_mm = Vec2(200, 100);
    options.scripted_height = calib::ScriptedHeight {
        .scenario = { .kind = calib::HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    std::vector const devices { pen };
    auto station = DrawingStation(Station::create(devices, options).value(), small_scene());
    // The report's position is the right far corner of the tablet.
    station.push(0, at_ms(0), drivers::bytes("01 ff 7f 00 00"));
    auto const moments = station.take_moments();
    ASSERT_FALSE(moments.empty());
    EXPECT_LT((moments.back().position_mm - Vec3(100, 50, 100)).norm(), 1e-6)
        << moments.back().position_mm.transpose();
}

TEST(Station, FinishesTheStrokeUnderWay)
{
    auto station = low_station();
    for (int i = 0; i < 20; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
    EXPECT_EQ(station.strokes().size(), 0u);
    EXPECT_EQ(station.inks().size(), 1u);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 1u);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 1u);
}

TEST(Station, KeepsTheStrokeOfAPenThatIsUnplugged)
{
    auto station = low_station();
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
    station.push(kPen, at_ms(50), {});
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.strokes()[0].stroke.tips.size(), 10u);
    EXPECT_TRUE(station.inks().empty());
    EXPECT_FALSE(station.pen_in_range());
    // When the tablet returns, the pen already touches. That must begin another stroke.
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5000 + 5 * i), pen_report(100 + 5 * i, 50, true));
    station.finish();
    EXPECT_EQ(station.strokes().size(), 2u);
    EXPECT_EQ(station.counts().reports, 20u);
    EXPECT_EQ(station.counts().broken_reports, 0u);
}

TEST(Station, KeepsTheStrokeWhoseHeightSensorIsUnplugged)
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    auto station = DrawingStation(Station::create(simple_rig(), options).value(), small_scene());
    auto const draw = [&](std::int64_t from_ms, bool with_height) {
        for (int i = 0; i < 20; ++i) {
            if (with_height)
                station.push(kHeight, at_ms(from_ms + 5 * i), height_report(1000));
            station.push(kPen, at_ms(from_ms + 5 * i + 1), pen_report(50 + 5 * i, 50, true));
        }
    };
    draw(0, true);
    EXPECT_EQ(station.strokes().size(), 0u);
    station.push(kHeight, at_ms(100), {});
    ASSERT_EQ(station.strokes().size(), 1u);
    auto const length = station.strokes()[0].stroke.tips.size();
    EXPECT_GE(length, 19u);
    draw(105, false); // While there is no height, nothing is drawn.
    EXPECT_TRUE(station.inks().empty());
    draw(1000, true);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 2u);
}

TEST(Station, TakesTwoTabletsAtOnce)
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    options.scripted_height = calib::ScriptedHeight {
        .scenario = { .kind = calib::HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    std::vector const devices { drivers::simple_pen(), drivers::simple_height_sensor(),
                                drivers::simple_pen() };
    DrawingStation station(Station::create(devices, options).value(), small_scene());
    constexpr std::size_t kSecondPen = 2;
    for (int i = 0; i < 20; ++i) {
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
        station.push(kSecondPen, at_ms(5 * i + 2), pen_report(50 + 5 * i, 90, true));
    }
    EXPECT_EQ(station.inks().size(), 2u);
    station.push(kPen, at_ms(100), pen_report(150, 50, false));
    EXPECT_EQ(station.strokes().size(), 1u);
    station.push(kSecondPen, at_ms(102), pen_report(150, 90, false));
    ASSERT_EQ(station.strokes().size(), 2u);
    EXPECT_NEAR(station.strokes()[0].stroke.tips.front().position_mm.y(), 0, 0.1);
    EXPECT_NEAR(station.strokes()[1].stroke.tips.front().position_mm.y(), -40, 0.1);
    EXPECT_EQ(station.strokes()[1].stroke.tips.size(), 20u);
    EXPECT_EQ(station.counts().ignored_reports, 0u);
    EXPECT_EQ(station.fuser_counts().pens, 42u);
}

TEST(Station, GivesAStrokeTheToolInHandWhenItBegan)
{
    auto station = low_station(tools::DrawInOrderTool {});
    // The tool is changed in the middle of the first stroke.
    station.set_tool(at_ms(50), indicators::IndicateTool {});
    draw_across(station, 0);
    draw_across(station, 200);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 2u);
    EXPECT_TRUE(station.strokes()[0].tool.get<tools::DrawInOrderTool>());
    EXPECT_TRUE(station.strokes()[1].tool.get<indicators::IndicateTool>());
    EXPECT_EQ(station.scene().associations.size(), 1u);
    EXPECT_EQ(station.scene().indicators.size(), 1u);
}

TEST(Station, KeepsTheReasonWhyAStrokeChangedNothing)
{
    auto station = low_station(tools::DrawTool {});
    draw_across(station, 0);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_NE(station.strokes()[0].refusal.find("select a branch first"), std::string::npos);
    EXPECT_TRUE(station.scene().associations.empty());
}

TEST(Station, CountsBrokenReportsAndGoesOn)
{
    auto station = low_station();
    station.push(kPen, at_ms(0), drivers::bytes("02 21 00"));
    station.push(kPen, at_ms(1), drivers::bytes("09 00 00"));
    draw_across(station, 5);
    station.finish();
    EXPECT_EQ(station.counts().broken_reports, 2u);
    EXPECT_NE(station.counts().first_broken.find("report 2"), std::string::npos)
        << station.counts().first_broken;
    EXPECT_EQ(station.strokes().size(), 1u);
}

// Returns a station after the pen has drawn for 400 ms. The cable of the height sensor was open
// from 200 to 350 ms.
DrawingStation station_with_an_open_cable()
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    auto station = DrawingStation(Station::create(simple_rig(), options).value(), small_scene());
    for (int ms = 0; ms < 400; ms += 2) {
        bool const is_open = ms >= 200 && ms < 350;
        station.push(kHeight, at_ms(ms), height_report(is_open ? 4095 : 1000 + ms % 3));
        station.push(kPen, at_ms(ms), pen_report(50 + 0.2 * ms, 50, true));
    }
    station.finish();
    return station;
}

TEST(Station, DrawsNoStrokeToWhereAnOpenCableReads)
{
    auto const station = station_with_an_open_cable();
    EXPECT_EQ(station.strokes().size(), 2u);
    for (auto const& drawn : station.strokes())
        for (auto const& tip : drawn.stroke.tips)
            EXPECT_NEAR(tip.position_mm.z(), 100, 0.5);
}

TEST(Station, SaysWhatIsWrongWithTheHeightSensor)
{
    EXPECT_EQ(calib::describe_faults(station_with_an_open_cable().height_monitor(), at_ms(0)),
              std::vector<std::string>(
                  { "the height sensor read 4095, an end of its range, once, for 0.1 s at 0.2 s: "
                    "its wiper or its cable is open, or the spool is at its stop" }));
}

TEST(Station, TellsWhenTheHeightSensorSaysNothing)
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    auto station = DrawingStation(Station::create(simple_rig(), options).value(), small_scene());
    draw_across(station, 0);
    draw_across(station, 500);
    ASSERT_TRUE(station.height_monitor().present());
    EXPECT_EQ(station.height_monitor().present()->kind, calib::HeightFaultKind::Silence);
}

TEST(Station, DoesNotMissASensorWhereTheHeightIsScripted)
{
    auto station = low_station();
    draw_across(station, 0);
    draw_across(station, 500);
    EXPECT_FALSE(station.height_monitor().present());
}

TEST(Station, LeavesOtherDevicesAside)
{
    auto station = low_station();
    station.push(7, at_ms(0), drivers::bytes("02 21 00"));
    EXPECT_EQ(station.counts().reports, 1u);
    EXPECT_EQ(station.counts().ignored_reports, 1u);
    EXPECT_EQ(station.counts().broken_reports, 0u);
}

TEST(Station, TakesHeightsFromTheSensorBetweenThePensReports)
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.rig.tablet_size_mm = { 200, 100 };
    options.rig.height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = -200 };
    auto station = DrawingStation(Station::create(simple_rig(), options).value(), small_scene());
    station.push(kHeight, at_ms(-1), height_report(1000));
    for (int i = 0; i < 20; ++i) {
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
        station.push(kHeight, at_ms(5 * i + 1), height_report(1000 + 10 * i));
    }
    station.finish();
    EXPECT_EQ(station.counts().height_samples, 21u);
    ASSERT_EQ(station.strokes().size(), 1u);
    auto const& tips = station.strokes()[0].stroke.tips;
    EXPECT_NEAR(tips.front().position_mm.z(), 120, 1);
    EXPECT_NEAR(tips.back().position_mm.z(), 139, 1);
}

// Returns a tablet that its driver has not switched yet: a mouse with tip pressure and 200 x 100
// counts. It never reports that the pen has left.
drivers::DeviceInfo mouse_with_pressure()
{
    return {
        .name = "Mouse",
        .report_descriptor = drivers::bytes(
            "05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
            "95 05 81 01 05 01 09 30 09 31 26 c8 00 95 02 75 10 81 02"
            "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0")
    };
}

DrawingStation station_with_mouse()
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    options.scripted_height = calib::ScriptedHeight {};
    std::vector const devices { mouse_with_pressure() };
    return DrawingStation(Station::create(devices, options).value(), small_scene());
}

// Sends twenty reports of a touching pen from the mouse, 5 ms apart, and nothing afterwards.
void touch_with_mouse(DrawingStation& station, std::int64_t start_ms)
{
    for (int i = 0; i < 20; ++i) {
        auto report = drivers::bytes("01 01 00 00 32 00 ff 0f");
        report[2] = static_cast<std::byte>(10 + 5 * i);
        station.push(0, at_ms(start_ms + 5 * i), report);
    }
}

TEST(Station, APenThatRestsInSilenceGoesOnWithItsStroke)
{
    auto station = station_with_mouse();
    touch_with_mouse(station, 0);
    // Up to now, the tablet has reported only changes, so silence does not mean that the pen has
    // left.
    station.pass_time(at_ms(60'000));
    EXPECT_TRUE(station.pen_in_range());
    EXPECT_TRUE(station.strokes().empty());
    station.push(0, at_ms(60'005), drivers::bytes("01 01 6a 00 32 00 ff 0f"));
    station.push(0, at_ms(60'010), drivers::bytes("01 00 6a 00 32 00 00 00"));
    EXPECT_EQ(station.strokes().size(), 1u);
}

// Sends equal reports of a resting pen, as a tablet does that streams all its reports.
void rest_with_mouse(DrawingStation& station, std::int64_t start_ms)
{
    for (int i = 0; i < 4; ++i)
        station.push(0, at_ms(start_ms + 5 * i), drivers::bytes("01 01 69 00 32 00 ff 0f"));
}

TEST(Station, SilenceEndsTheStrokeOfAPenThatStreamedAndCannotSayThatItHasLeft)
{
    auto station = station_with_mouse();
    touch_with_mouse(station, 0);
    rest_with_mouse(station, 100);
    station.pass_time(at_ms(215)); // 100 ms after the last report.
    EXPECT_TRUE(station.pen_in_range());
    station.pass_time(at_ms(216));
    EXPECT_FALSE(station.pen_in_range());
    EXPECT_EQ(station.strokes().size(), 1u);
}

TEST(Station, ReportsPassTheTimeOfTheData)
{
    auto station = station_with_mouse();
    rest_with_mouse(station, 0);
    for (int const start_ms : { 20, 1020 })
        touch_with_mouse(station, start_ms);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 2u);
}

TEST(Station, NeedsAPenAndAHeight)
{
    StationOptions options;
    options.tools = methods::all_methods().tools;
    auto const without_pen
        = Station::create(std::vector { drivers::simple_height_sensor() }, options);
    ASSERT_FALSE(without_pen);
    EXPECT_NE(without_pen.error().message.find("no pen"), std::string::npos);
    auto const without_height = Station::create(std::vector { drivers::simple_pen() }, options);
    ASSERT_FALSE(without_height);
    EXPECT_NE(without_height.error().message.find("--height"), std::string::npos);
    auto const nothing = Station::create({}, options);
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().message.find("no device at all"), std::string::npos);
}

} // namespace
} // namespace tractus::station
