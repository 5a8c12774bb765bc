#include "app/station/station.h"

#include "tests/app/simple_rig.h"
#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

// At a height of 100 mm that no sensor measures.
Station flat_station(Tool const& tool = {})
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    options.scripted_height = ScriptedHeight {
        .scenario = { .kind = HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    options.scene = small_scene();
    options.tool = tool;
    return Station::create(simple_rig(), std::move(options)).value();
}

TEST(Station, KnowsWhatThePenReaches)
{
    auto const volume = flat_station().volume_mm();
    EXPECT_LT((volume.min_mm - Vec3(-100, -50, 0)).norm(), 1e-9);
    EXPECT_LT((volume.max_mm - Vec3(100, 50, 300)).norm(), 1e-9);
    StationOptions options;
    options.rig = { .height_model = LinearHeight { .mm_per_count = 0.1, .zero_counts = 500 },
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
    auto station = flat_station();
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

TEST(Station, FinishesTheStrokeUnderWay)
{
    auto station = flat_station();
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
    auto station = flat_station();
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + 5 * i, 50, true));
    station.push(kPen, at_ms(50), {});
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.strokes()[0].stroke.tips.size(), 10u);
    EXPECT_TRUE(station.inks().empty());
    EXPECT_FALSE(station.pen_in_range());
    // It comes back while the pen touches: that is another stroke.
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
    options.rig.tablet_size_mm = { 200, 100 };
    options.scene = small_scene();
    auto station = Station::create(simple_rig(), std::move(options)).value();
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
    draw(105, false); // Without a height, nothing is drawn.
    EXPECT_TRUE(station.inks().empty());
    draw(1000, true);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 2u);
}

TEST(Station, TakesTwoTabletsAtOnce)
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    options.scripted_height = ScriptedHeight {
        .scenario = { .kind = HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    options.scene = small_scene();
    auto station
        = Station::create(std::vector { simple_pen(), simple_height_sensor(), simple_pen() },
                          std::move(options))
              .value();
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
    auto station = flat_station({ Tool::Kind::DrawInOrder });
    station.set_tool(at_ms(50), { Tool::Kind::Indicate }); // In the middle of the first stroke.
    draw_across(station, 0);
    draw_across(station, 200);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 2u);
    EXPECT_EQ(station.strokes()[0].tool.kind, Tool::Kind::DrawInOrder);
    EXPECT_EQ(station.strokes()[1].tool.kind, Tool::Kind::Indicate);
    EXPECT_EQ(station.scene().associations.size(), 1u);
    EXPECT_EQ(station.scene().indicators.size(), 1u);
}

TEST(Station, KeepsTheReasonWhyAStrokeChangedNothing)
{
    auto station = flat_station({ Tool::Kind::Draw });
    draw_across(station, 0);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_NE(station.strokes()[0].refusal.find("select a branch first"), std::string::npos);
    EXPECT_TRUE(station.scene().associations.empty());
}

TEST(Station, CountsBrokenReportsAndGoesOn)
{
    auto station = flat_station();
    station.push(kPen, at_ms(0), bytes("02 21 00"));
    station.push(kPen, at_ms(1), bytes("09 00 00"));
    draw_across(station, 5);
    station.finish();
    EXPECT_EQ(station.counts().broken_reports, 2u);
    EXPECT_NE(station.counts().first_broken.find("report 2"), std::string::npos)
        << station.counts().first_broken;
    EXPECT_EQ(station.strokes().size(), 1u);
}

// Draws for 400 ms; the sensor's cable is open between 200 and 350 ms.
Station station_with_an_open_cable()
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    options.scene = small_scene();
    auto station = Station::create(simple_rig(), std::move(options)).value();
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
    EXPECT_EQ(describe_faults(station_with_an_open_cable().height_monitor(), at_ms(0)),
              std::vector<std::string>(
                  { "the height sensor read 4095, an end of its range, once, for 0.1 s at 0.2 s: "
                    "its wiper or its cable is open, or the spool is at its stop" }));
}

TEST(Station, TellsWhenTheHeightSensorSaysNothing)
{
    StationOptions options;
    options.scene = small_scene();
    auto station = Station::create(simple_rig(), std::move(options)).value();
    draw_across(station, 0);
    draw_across(station, 500);
    ASSERT_TRUE(station.height_monitor().present());
    EXPECT_EQ(station.height_monitor().present()->kind, HeightFaultKind::Silence);
}

TEST(Station, DoesNotMissASensorWhereTheHeightIsScripted)
{
    auto station = flat_station();
    draw_across(station, 0);
    draw_across(station, 500);
    EXPECT_FALSE(station.height_monitor().present());
}

TEST(Station, LeavesOtherDevicesAside)
{
    auto station = flat_station();
    station.push(7, at_ms(0), bytes("02 21 00"));
    EXPECT_EQ(station.counts().reports, 1u);
    EXPECT_EQ(station.counts().ignored_reports, 1u);
    EXPECT_EQ(station.counts().broken_reports, 0u);
}

TEST(Station, TakesHeightsFromTheSensorBetweenThePensReports)
{
    StationOptions options;
    options.rig.tablet_size_mm = { 200, 100 };
    options.rig.height_model = LinearHeight { .mm_per_count = 0.1, .zero_counts = -200 };
    options.scene = small_scene();
    auto station = Station::create(simple_rig(), std::move(options)).value();
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

// A tablet that its own driver has not switched: a mouse with tip pressure, 200 x 100 counts, which
// never says that the pen has gone.
DeviceInfo mouse_with_pressure()
{
    return {
        .name = "Mouse",
        .report_descriptor = bytes(
            "05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
            "95 05 81 01 05 01 09 30 09 31 26 c8 00 95 02 75 10 81 02"
            "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0")
    };
}

Station station_with_mouse()
{
    StationOptions options;
    options.scripted_height = ScriptedHeight {};
    options.scene = small_scene();
    std::vector const devices { mouse_with_pressure() };
    return Station::create(devices, std::move(options)).value();
}

// Twenty reports of the mouse's tip, 5 ms apart, and not another word.
void touch_with_mouse(Station& station, std::int64_t start_ms)
{
    for (int i = 0; i < 20; ++i) {
        auto report = bytes("01 01 00 00 32 00 ff 0f");
        report[2] = static_cast<std::byte>(10 + 5 * i);
        station.push(0, at_ms(start_ms + 5 * i), report);
    }
}

TEST(Station, ASilenceOf100MsEndsTheStrokeOfAPenThatCannotSayThatItHasLeft)
{
    auto station = station_with_mouse();
    touch_with_mouse(station, 0);
    station.pass_time(at_ms(195)); // 100 ms after the last report.
    EXPECT_TRUE(station.pen_in_range());
    station.pass_time(at_ms(196));
    EXPECT_FALSE(station.pen_in_range());
    EXPECT_EQ(station.strokes().size(), 1u);
}

TEST(Station, ReportsPassTheTimeOfTheData)
{
    auto station = station_with_mouse();
    for (int const start_ms : { 0, 1000 })
        touch_with_mouse(station, start_ms);
    station.finish();
    EXPECT_EQ(station.strokes().size(), 2u);
}

TEST(Station, NeedsAPenAndAHeight)
{
    StationOptions options;
    options.scene = small_scene();
    auto const without_pen = Station::create(std::vector { simple_height_sensor() }, options);
    ASSERT_FALSE(without_pen);
    EXPECT_NE(without_pen.error().message.find("no pen"), std::string::npos);
    auto const without_height = Station::create(std::vector { simple_pen() }, options);
    ASSERT_FALSE(without_height);
    EXPECT_NE(without_height.error().message.find("--height"), std::string::npos);
    auto const nothing = Station::create({}, options);
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().message.find("no device at all"), std::string::npos);
}

// The pen from one place to another, down all the way, then up; x and y of the tablet.
void touch_along(Station& station, std::int64_t start_ms, Vec2 const& from_mm, Vec2 const& to_mm)
{
    for (int i = 0; i < 20; ++i) {
        Vec2 const at_mm = from_mm + (to_mm - from_mm) * i / 19;
        station.push(kPen, at_ms(start_ms + 5 * i), pen_report(at_mm.x(), at_mm.y(), true));
    }
    station.push(kPen, at_ms(start_ms + 100), pen_report(to_mm.x(), to_mm.y(), false));
}

Eigen::AlignedBox2d left_part()
{
    return { Vec2(-100, -50), Vec2(-60, 50) }; // x of the tablet below 40 mm.
}

TEST(Station, PressesWhereATouchBeginsInAnAreaForIt)
{
    auto station = flat_station({ .kind = Tool::Kind::Indicate });
    station.set_pressing_areas({ left_part() });
    touch_along(station, 0, { 30, 50 }, { 100, 50 }); // Out of the area: still a press.
    EXPECT_FALSE(station.is_pressing());
    touch_along(station, 200, { 100, 50 }, { 30, 50 }); // Into it: still a stroke.
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.counts().strokes, 1u);
    EXPECT_EQ(station.strokes()[0].tool.kind, Tool::Kind::Indicate);
    EXPECT_EQ(station.scene().indicators.size(), 1u);

    auto const moments = station.take_moments();
    ASSERT_EQ(moments.size(), 42u);
    EXPECT_TRUE(moments[0].touching && moments[0].pressing);
    EXPECT_TRUE(moments[19].pressing);
    EXPECT_FALSE(moments[20].touching || moments[20].pressing);
    EXPECT_TRUE(moments[21].touching && !moments[21].pressing);
    EXPECT_TRUE(station.take_moments().empty());
}

TEST(Station, TakesAToolThatWasChosenByPressing)
{
    auto station = flat_station({ .kind = Tool::Kind::Select });
    station.set_pressing_areas({ left_part() });
    station.push(kPen, at_ms(0), pen_report(30, 50, true));
    EXPECT_TRUE(station.is_pressing());
    station.set_tool(at_ms(3), { .kind = Tool::Kind::Indicate });
    EXPECT_TRUE(station.is_pressing()) << "the press goes on";
    EXPECT_EQ(station.tool().kind, Tool::Kind::Indicate);
    station.push(kPen, at_ms(5), pen_report(40, 50, true));
    station.push(kPen, at_ms(10), pen_report(40, 50, false));
    touch_along(station, 20, { 100, 50 }, { 150, 50 });
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.strokes()[0].tool.kind, Tool::Kind::Indicate);

    auto const changes = station.take_tool_changes();
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].tool.kind, Tool::Kind::Press);
    EXPECT_EQ(changes[0].time, at_ms(0));
    EXPECT_EQ(changes[1].tool.kind, Tool::Kind::Indicate);
    EXPECT_EQ(changes[1].time, at_ms(10));
}

TEST(Station, TakesBackAStrokeThatTurnsOutToBeAPress)
{
    auto station = flat_station();
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + i, 50, true));
    station.press_instead();
    EXPECT_TRUE(station.is_pressing());
    station.push(kPen, at_ms(50), pen_report(60, 50, false));
    EXPECT_FALSE(station.is_pressing());
    station.press_instead(); // Nothing touches: nothing happens.
    draw_across(station, 100);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.strokes()[0].stroke.tips.size(), 20u);
}

TEST(Station, ReplaysPressesFromTheToolLinesOfARecording)
{
    auto live = flat_station({ .kind = Tool::Kind::Indicate });
    live.set_pressing_areas({ left_part() });
    touch_along(live, 0, { 30, 50 }, { 100, 50 });
    touch_along(live, 200, { 100, 50 }, { 150, 60 });
    auto const changes = live.take_tool_changes();
    ASSERT_EQ(changes.size(), 2u);

    auto replayed = flat_station({ .kind = Tool::Kind::Indicate });
    replayed.set_tool(changes[0].time, changes[0].tool);
    touch_along(replayed, 0, { 30, 50 }, { 100, 50 });
    replayed.set_tool(changes[1].time, changes[1].tool);
    touch_along(replayed, 200, { 100, 50 }, { 150, 60 });
    live.finish();
    replayed.finish();
    ASSERT_EQ(live.strokes().size(), 1u);
    ASSERT_EQ(replayed.strokes().size(), 1u);
    EXPECT_EQ(replayed.strokes()[0].stroke.tips.front().position_mm,
              live.strokes()[0].stroke.tips.front().position_mm);
}

TEST(Station, DoesAtOnceWhatNeedsNoStroke)
{
    auto station = flat_station({ .kind = Tool::Kind::Indicate });
    station.set_tool(
        at_ms(0),
        { .kind = Tool::Kind::Select, .selecting = Tool::Selecting::Invert, .at_once = true });
    EXPECT_FALSE(station.scene().selection.empty());
    EXPECT_EQ(station.tool().kind, Tool::Kind::Indicate);
    EXPECT_EQ(station.strokes().size(), 1u) << "it is kept like a stroke";
    EXPECT_EQ(words_for(station.take_tool_changes().at(0).tool).arguments, "invert now");
}

// Ten samples of the pen's other end across a line, 1 mm and 5 ms apart.
void erase_across(Station& station, std::int64_t start_ms, double x_mm, double y_mm)
{
    for (int i = 0; i < 10; ++i) {
        auto report = pen_report(x_mm, y_mm + i, true);
        report[1] = std::byte { 0x38 }; // In range, eraser, invert.
        station.push(kPen, at_ms(start_ms + 5 * i), report);
    }
    station.push(kPen, at_ms(start_ms + 60), pen_report(x_mm, y_mm, false));
}

// Strokes and what the pen's other end erases of them, before and after that is chosen.
Station drawn_and_erased(std::vector<Station::ToolChange> const& changes)
{
    auto station = flat_station();
    for (std::int64_t second = 0; second < 6; ++second) {
        for (auto const& [time, tool] : changes)
            if (time >= at_ms(1000 * second) && time < at_ms(1000 * (second + 1)))
                station.set_tool(time, tool);
        if (second % 2 == 0)
            draw_across(station, 1000 * second + 100);
        else
            erase_across(station, 1000 * second + 100, 140, 45);
    }
    station.finish();
    return station;
}

TEST(Station, ErasesWithThePensOtherEndAsItDidLast)
{
    Tool const part { .kind = Tool::Kind::Erase, .erasing = Tool::Erasing::Part };
    auto live = drawn_and_erased({ { at_ms(2000), part },
                                   { at_ms(2050), { Tool::Kind::DrawInOrder } },
                                   { at_ms(5000), { Tool::Kind::Erase } } });
    ASSERT_EQ(live.strokes().size(), 6u);
    for (auto const& drawn : live.strokes())
        EXPECT_EQ(drawn.refusal, "");
    EXPECT_TRUE(std::holds_alternative<DeleteStroke>(live.strokes()[1].edits[0]));
    EXPECT_EQ(live.strokes()[3].tool, part);
    EXPECT_TRUE(std::holds_alternative<EraseTips>(live.strokes()[3].edits[0]));
    EXPECT_TRUE(std::holds_alternative<DeleteStroke>(live.strokes()[5].edits[0]));

    // The same again from the tool lines of a recording, to the last bit.
    std::vector<Station::ToolChange> recorded;
    for (auto const& [time, tool] : live.take_tool_changes()) {
        auto const words = words_for(tool);
        recorded.push_back({ time, parse_tool(words.name, words.arguments).value() });
    }
    ASSERT_EQ(recorded.size(), 3u);
    auto const replayed = drawn_and_erased(recorded);
    ASSERT_EQ(replayed.scene().associations.size(), live.scene().associations.size());
    for (std::size_t i = 0; i < live.scene().associations.size(); ++i) {
        auto const& one = live.scene().associations[i].stroke.tips;
        auto const& other = replayed.scene().associations[i].stroke.tips;
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t tip = 0; tip < one.size(); ++tip)
            EXPECT_EQ(one[tip].position_mm, other[tip].position_mm);
    }
}

TEST(Station, RemembersForHoursHowThePensOtherEndErases)
{
    auto station = flat_station();
    Tool const part { .kind = Tool::Kind::Erase, .erasing = Tool::Erasing::Part };
    station.set_tool(at_ms(0), part);
    constexpr std::int64_t kHour_ms = 3'600'000;
    for (int i = 0; i < 4; ++i)
        station.set_tool(at_ms((i + 1) * kHour_ms),
                         { i % 2 == 0 ? Tool::Kind::DrawInOrder : Tool::Kind::Indicate });
    EXPECT_EQ(station.erasing(), Tool::Erasing::Part);
    EXPECT_EQ(station.tools_to_go_on_with(),
              (std::vector<Tool> { part, { Tool::Kind::Indicate } }));
    station.set_tool(at_ms(5 * kHour_ms), part);
    EXPECT_EQ(station.tools_to_go_on_with(), std::vector<Tool> { part });
}

TEST(Station, ErasesWithThePensOtherEnd)
{
    auto station = flat_station({ .kind = Tool::Kind::Indicate });
    touch_along(station, 0, { 50, 50 }, { 150, 50 });
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.scene().indicators.size(), 1u);
    erase_across(station, 300, 100, 70); // Beside it.
    ASSERT_EQ(station.strokes().size(), 2u);
    EXPECT_NE(station.strokes()[1].refusal, "");
    EXPECT_EQ(station.scene().indicators.size(), 1u);
    erase_across(station, 600, 100, 45);
    ASSERT_EQ(station.strokes().size(), 3u);
    EXPECT_EQ(station.strokes()[2].tool.kind, Tool::Kind::Erase);
    EXPECT_EQ(station.strokes()[2].refusal, "");
    EXPECT_TRUE(station.scene().indicators.empty());
}

} // namespace
} // namespace tractus
