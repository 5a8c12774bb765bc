#include "app/methods/all_methods.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/station/pressing.h"
#include "app/station/station.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"
#include "tests/app/flat_station.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::station {
namespace {

DrawingStation station_in_hand(std::optional<tools::Tool> const& tool = {})
{
    return station_on(small_scene(), tool);
}

// Draws a line between two points with the pen down, and then lifts it. The points are in tablet
// coordinates.
void touch_along(DrawingStation& station, std::int64_t start_ms, Vec2 const& from_mm,
                 Vec2 const& to_mm)
{
    for (int i = 0; i < 20; ++i) {
        Vec2 const at_mm = from_mm + (to_mm - from_mm) * i / 19;
        station.push(kPen, at_ms(start_ms + 5 * i), pen_report(at_mm.x(), at_mm.y(), true));
    }
    station.push(kPen, at_ms(start_ms + 100), pen_report(to_mm.x(), to_mm.y(), false));
}

Eigen::AlignedBox2d left_part()
{
    return { Vec2(-100, -50), Vec2(-60, 50) }; // The area with x below 40 mm on the tablet.
}

TEST(StationTools, PressesWhereATouchBeginsInAnAreaForIt)
{
    auto station = station_in_hand(indicators::IndicateTool {});
    station.set_pressing_areas({ left_part() });
    // The touch begins in the area, so it is a press even when it leaves the area.
    touch_along(station, 0, { 30, 50 }, { 100, 50 });
    EXPECT_FALSE(station.is_pressing());
    // The touch begins outside the area, so it is a stroke even when it enters the area.
    touch_along(station, 200, { 100, 50 }, { 30, 50 });
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.counts().strokes, 1u);
    EXPECT_TRUE(station.strokes()[0].tool.get<indicators::IndicateTool>());
    EXPECT_EQ(station.scene().indicators.size(), 1u);

    auto const moments = station.take_moments();
    ASSERT_EQ(moments.size(), 42u);
    EXPECT_TRUE(moments[0].touching && moments[0].pressing);
    EXPECT_TRUE(moments[19].pressing);
    EXPECT_FALSE(moments[20].touching || moments[20].pressing);
    EXPECT_TRUE(moments[21].touching && !moments[21].pressing);
    EXPECT_TRUE(station.take_moments().empty());
}

// Reports of both devices arrive in bursts, and their times are evened. A recording of these times
// in whole microseconds must distinguish presses from strokes in the same way.
TEST(StationTools, PressesWhereReportsComeInBursts)
{
    StationOptions options;
    options.rig = { .height_model = calib::LinearHeight { .mm_per_count = 0.1 },
                    .tablet_size_mm = { 200, 100 },
                    .sample_times = calib::SampleTimes::Evened };
    options.tools = methods::all_methods().tools;
    auto station = Station::create(simple_rig(), options).value();
    station.set_pressing_areas({ left_part() });
    std::int64_t pen_us = 0;
    for (std::int64_t burst_ms = 16; burst_ms < 4000; burst_ms += 16) {
        for (int i = 0; i < 4; ++i)
            station.push(kHeight, at_ms(burst_ms), height_report(1000));
        for (; pen_us < 1000 * burst_ms; pen_us += 7310) {
            auto const part_us = pen_us - 2'000'000;
            bool const touches = part_us > 0 && part_us % 400'000 < 200'000;
            bool const presses = part_us < 400'000 || part_us > 800'000;
            double const along_mm
                = static_cast<double>(std::max<std::int64_t>(part_us, 0) % 400'000) / 1e4;
            station.push(kPen, at_ms(burst_ms),
                         pen_report(presses ? 30 : 100 + along_mm, 40 + along_mm, touches));
        }
    }
    station.finish();
    auto const strokes = station.take_strokes();
    ASSERT_EQ(strokes.size(), 1u);
    auto const& tips = strokes[0].stroke.tips;
    EXPECT_GT(tips.size(), 20u);
    for (std::size_t i = 1; i < tips.size(); ++i)
        EXPECT_NEAR(to_seconds(tips[i].time - tips[i - 1].time), 0.00731, 0.0005);
}

TEST(StationTools, TakesAToolThatWasChosenByPressing)
{
    auto station = station_in_hand(tools::SelectTool {});
    station.set_pressing_areas({ left_part() });
    station.push(kPen, at_ms(0), pen_report(30, 50, true));
    EXPECT_TRUE(station.is_pressing());
    station.set_tool(at_ms(3), indicators::IndicateTool {});
    EXPECT_TRUE(station.is_pressing()) << "the press goes on";
    EXPECT_TRUE(station.tool().get<indicators::IndicateTool>());
    station.push(kPen, at_ms(5), pen_report(40, 50, true));
    station.push(kPen, at_ms(10), pen_report(40, 50, false));
    touch_along(station, 20, { 100, 50 }, { 150, 50 });
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_TRUE(station.strokes()[0].tool.get<indicators::IndicateTool>());

    auto const changes = station.take_tool_changes();
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].tool, pressing());
    EXPECT_EQ(changes[0].time, at_ms(0));
    EXPECT_TRUE(changes[1].tool.get<indicators::IndicateTool>());
    EXPECT_EQ(changes[1].time, at_ms(10));
}

TEST(StationTools, TakesBackAStrokeThatTurnsOutToBeAPress)
{
    auto station = station_in_hand();
    for (int i = 0; i < 10; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50 + i, 50, true));
    station.convert_touch_to_press();
    EXPECT_TRUE(station.is_pressing());
    station.push(kPen, at_ms(50), pen_report(60, 50, false));
    EXPECT_FALSE(station.is_pressing());
    station.convert_touch_to_press(); // There is no touch, so this has no effect.
    draw_across(station, 100);
    station.finish();
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.strokes()[0].stroke.tips.size(), 20u);
}

TEST(StationTools, ReplaysPressesFromTheToolLinesOfARecording)
{
    auto live = station_in_hand(indicators::IndicateTool {});
    live.set_pressing_areas({ left_part() });
    touch_along(live, 0, { 30, 50 }, { 100, 50 });
    touch_along(live, 200, { 100, 50 }, { 150, 60 });
    auto const changes = live.take_tool_changes();
    ASSERT_EQ(changes.size(), 2u);

    auto replayed = station_in_hand(indicators::IndicateTool {});
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

TEST(StationTools, DoesAtOnceWhatNeedsNoStroke)
{
    auto station = station_in_hand(indicators::IndicateTool {});
    station.set_tool(
        at_ms(0),
        tools::Tool(tools::SelectTool { .selecting = tools::SelectTool::SelectionMode::Invert })
            .done_at_once());
    EXPECT_FALSE(station.scene().selection.empty());
    EXPECT_TRUE(station.tool().get<indicators::IndicateTool>());
    EXPECT_EQ(station.strokes().size(), 1u) << "it is kept like a stroke";
    EXPECT_EQ(tools::words_for(station.take_tool_changes().at(0).tool).arguments, "invert now");
}

// Erases across a line with the pen's other end: ten samples, 1 mm and 5 ms apart.
void erase_across(DrawingStation& station, std::int64_t start_ms, double x_mm, double y_mm)
{
    for (int i = 0; i < 10; ++i) {
        auto report = pen_report(x_mm, y_mm + i, true);
        report[1] = std::byte { 0x38 }; // The flags "in range", "eraser" and "invert".
        station.push(kPen, at_ms(start_ms + 5 * i), report);
    }
    station.push(kPen, at_ms(start_ms + 60), pen_report(x_mm, y_mm, false));
}

// Returns a station on which strokes alternate with erasures by the pen's other end, one each
// second. The tools are changed at the given times.
DrawingStation drawn_and_erased(std::vector<Station::ToolChange> const& changes)
{
    auto station = station_in_hand();
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

TEST(StationTools, ErasesWithThePensOtherEndAsItDidLast)
{
    tools::Tool const part = tools::EraseTool { .erasing = tools::EraseTool::EraseExtent::Part };
    auto live = drawn_and_erased({ { at_ms(2000), part },
                                   { at_ms(2050), tools::DrawInOrderTool {} },
                                   { at_ms(5000), tools::EraseTool {} } });
    ASSERT_EQ(live.strokes().size(), 6u);
    for (auto const& drawn : live.strokes())
        EXPECT_EQ(drawn.refusal, "");
    EXPECT_TRUE(live.strokes()[1].edits[0].get<scene::DeleteStroke>());
    EXPECT_EQ(live.strokes()[3].tool, part);
    EXPECT_TRUE(live.strokes()[3].edits[0].get<scene::EraseTips>());
    EXPECT_TRUE(live.strokes()[5].edits[0].get<scene::DeleteStroke>());

    // The tool lines of a recording must give the same result, to the last bit.
    std::vector<Station::ToolChange> recorded;
    for (auto const& [time, tool] : live.take_tool_changes()) {
        auto const words = tools::words_for(tool);
        recorded.push_back(
            { time,
              words.name == pressing().kind().word
                  ? pressing()
                  : tools::parse_tool(methods::all_methods().tools, words.name, words.arguments)
                        .value() });
    }
    ASSERT_EQ(recorded.size(), 3u);
    auto const replayed = drawn_and_erased(recorded);
    ASSERT_EQ(replayed.scene().associations.size(), live.scene().associations.size());
    for (std::size_t i = 0; i < live.scene().associations.size(); ++i) {
        auto const& one = live.scene().associations[i].what.stroke.tips;
        auto const& other = replayed.scene().associations[i].what.stroke.tips;
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t tip = 0; tip < one.size(); ++tip)
            EXPECT_EQ(one[tip].position_mm, other[tip].position_mm);
    }
}

TEST(StationTools, RemembersForHoursHowThePensOtherEndErases)
{
    auto station = station_in_hand();
    tools::Tool const part = tools::EraseTool { .erasing = tools::EraseTool::EraseExtent::Part };
    station.set_tool(at_ms(0), part);
    constexpr std::int64_t kHour_ms = 3'600'000;
    for (int i = 0; i < 4; ++i)
        station.set_tool(at_ms((i + 1) * kHour_ms),
                         i % 2 == 0 ? tools::Tool(tools::DrawInOrderTool {})
                                    : tools::Tool(indicators::IndicateTool {}));
    EXPECT_EQ(station.remembered(), std::vector<tools::Tool> { part });
    EXPECT_EQ(station.tools_for_continuation(),
              (std::vector<tools::Tool> { part, indicators::IndicateTool {} }));
    station.set_tool(at_ms(5 * kHour_ms), part);
    EXPECT_EQ(station.tools_for_continuation(), std::vector<tools::Tool> { part });
}

TEST(StationTools, ErasesWithThePensOtherEnd)
{
    auto station = station_in_hand(indicators::IndicateTool {});
    touch_along(station, 0, { 50, 50 }, { 150, 50 });
    ASSERT_EQ(station.strokes().size(), 1u);
    EXPECT_EQ(station.scene().indicators.size(), 1u);
    erase_across(station, 300, 100, 70); // The eraser passes beside the line.
    ASSERT_EQ(station.strokes().size(), 2u);
    EXPECT_NE(station.strokes()[1].refusal, "");
    EXPECT_EQ(station.scene().indicators.size(), 1u);
    erase_across(station, 600, 100, 45);
    ASSERT_EQ(station.strokes().size(), 3u);
    EXPECT_TRUE(station.strokes()[2].tool.get<tools::EraseTool>());
    EXPECT_EQ(station.strokes()[2].refusal, "");
    EXPECT_TRUE(station.scene().indicators.empty());
}

} // namespace
} // namespace tractus::station
