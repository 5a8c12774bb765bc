#include "app/stream/stream_lines.h"

#include "app/tools/draw_tool.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tractus::stream {
namespace {

TEST(StreamLines, BeginWithTheVersion)
{
    EXPECT_EQ(stream_line({ { -127, -79.5, 0 }, { 127, 79.5, 350 } }),
              "{\"type\":\"stream\",\"version\":1,\"volume_mm\":"
              "[[-127.000,-79.500,0.000],[127.000,79.500,350.000]]}\n");
}

TEST(StreamLines, HaveATipWithItsTimeToTheNanosecond)
{
    station::PenMoment const moment { .in_range = true,
                                      .touching = true,
                                      .pressure = 0.25,
                                      .position_mm = { -0.0001, 2, 3.14159 },
                                      .time = timestamp_ns(
                                          // This number has more digits than a double can hold.
                                          9'007'199'254'740'993) };
    EXPECT_EQ(tip_line(moment),
              "{\"type\":\"tip\",\"pen\":0,\"time_s\":9007199.254740993,"
              "\"position_mm\":[0.000,2.000,3.142],\"pressure\":0.2500,"
              "\"touching\":true,\"in_range\":true,\"eraser\":false}\n");
}

TEST(StreamLines, HaveTheTiltWhereTheTabletTellsIt)
{
    station::PenMoment moment;
    moment.tilt_rad = Vec2(kPi / 6, -kPi / 4);
    auto const json = nlohmann::json::parse(tip_line(moment));
    EXPECT_EQ(json["tilt_deg"], (std::vector { 30.0, -45.0 }));
}

TEST(StreamLines, CountTimesBeforeALogsBeginning)
{
    station::PenMoment moment;
    moment.time = timestamp_ns(-5'000'001);
    EXPECT_NE(tip_line(moment).find("\"time_s\":-0.005000001,"), std::string::npos);
}

TEST(StreamLines, HaveAStrokeWithWhatItIsFor)
{
    tools::ToolStroke stroke { {}, tools::DrawTool { variation::Propagation::Both } };
    stroke.stroke.tips.push_back(
        { .time = timestamp_ns(1'000'000), .position_mm = { 1, 2, 3 }, .pressure = 0.5 });
    stroke.stroke.tips.push_back(
        { .time = timestamp_ns(6'000'000), .position_mm = { 4, 5, 6.0006 }, .pressure = 1 });
    EXPECT_EQ(stroke_line(7, stroke),
              "{\"type\":\"stroke\",\"number\":7,\"tool\":\"draw\",\"arguments\":\"both heading "
              "from_foot\","
              "\"eraser\":false,\"tips\":[[1.000,2.000,3.000,0.5000,0.001000000],"
              "[4.000,5.000,6.001,1.0000,0.006000000]]}\n");
}

TEST(StreamLines, HaveAStepWithTheStrokeThatItIsOf)
{
    EXPECT_EQ(step_line(3, timestamp_ns(1'000'000), timestamp_ns(6'000'000), { 4, 5, 6.0006 }),
              "{\"type\":\"step\",\"number\":3,\"stroke_time_s\":0.001000000,"
              "\"time_s\":0.006000000,\"position_mm\":[4.000,5.000,6.001]}\n");
}

TEST(StreamLines, AreAllJson)
{
    for (auto const& line : { lost_line(12), end_line(), stream_line({}) }) {
        EXPECT_EQ(line.back(), '\n');
        EXPECT_FALSE(nlohmann::json::parse(line, nullptr, false).is_discarded()) << line;
    }
}

} // namespace
} // namespace tractus::stream
