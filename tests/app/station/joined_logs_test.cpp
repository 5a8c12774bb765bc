#include "app/station/log_replay.h"
#include "drivers/logs/log_writer.h"
#include "tests/app/station/pressed_pens.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <string>

// Tests of recordings that were concatenated, or continued after a restart. Their times go back.

namespace tractus::station {
namespace {

std::string line(double seconds, std::vector<std::byte> const& report)
{
    auto text = fmt::format("E: {:013.6f} {}", seconds, report.size());
    for (auto const byte : report)
        text += fmt::format(" {:02x}", std::to_integer<int>(byte));
    return text + "\n";
}

std::string head()
{
    std::string text;
    int number = 0;
    for (auto const& device : { drivers::simple_pen(), drivers::simple_height_sensor() }) {
        text += fmt::format("D: {}\nR: {}", number++, device.report_descriptor.size());
        for (auto const byte : device.report_descriptor)
            text += fmt::format(" {:02x}", std::to_integer<int>(byte));
        text += "\n";
    }
    return text
        + "C: version = 2\nC: [height]\nC: model = \"linear\"\nC: mm_per_count = 0.1\n"
          "C: zero_counts = 0\nC: full_scale_counts = 4095\nC: calibrated_counts = [0, 4095]\n"
          "C: latency_ms = 0\nC: [tablet]\nC: size_mm = [200, 100]\nC: latency_ms = 0\n";
}

// Returns half a second of reports from `first_s` on. The pen touches after the first 0.1 s, and
// lifts at the end if `lifts` is true. The surface is at rest at `counts`.
std::string part(double first_s, int counts, bool lifts)
{
    std::string text;
    for (int i = 0; i < 100; ++i) {
        double const seconds = first_s + 0.005 * i;
        text += "D: 1\n" + line(seconds, height_report(counts)) + "D: 0\n"
            + line(seconds + 0.001,
                   standard_pen().report({ .x_mm = 20.0 + i,
                                           .y_mm = 50,
                                           .touching = i >= 20 && (i < 99 || !lifts) }));
    }
    return text;
}

struct Replayed {
    std::vector<tools::ToolStroke> strokes;
    std::vector<std::string> warnings;
};

Replayed replay(std::string const& text)
{
    auto const log = drivers::parse_log(text, "joined.tractus-log").value();
    auto replay = LogReplay::create(log, {}).value();
    replay.advance_to(Timestamp::max());
    Replayed replayed { replay.station().take_strokes(), {} };
    for (auto const& warning : log.warnings)
        replayed.warnings.push_back(fmt::format("{}: {}", warning.line, warning.message));
    return replayed;
}

TEST(JoinedLogs, HaveTheStrokesOfEachPart)
{
    for (bool const lifts : { true, false })
        for (double const second_s : { 0.0, 3.0, 4.2 }) {
            auto const first = head() + part(5, 1000, lifts);
            auto const second = head() + part(second_s, 3000, lifts);
            auto const one = replay(first);
            auto const other = replay(second);
            auto const both = replay(first + second);
            ASSERT_EQ(one.strokes.size(), 1u);
            ASSERT_EQ(other.strokes.size(), 1u);
            ASSERT_EQ(both.strokes.size(), 2u) << lifts << " " << second_s;
            for (auto const& [stroke, alone] :
                 { std::pair { both.strokes[0], one.strokes[0] },
                   std::pair { both.strokes[1], other.strokes[0] } }) {
                ASSERT_EQ(stroke.stroke.tips.size(), alone.stroke.tips.size());
                for (std::size_t i = 0; i < stroke.stroke.tips.size(); ++i)
                    EXPECT_LT((stroke.stroke.tips[i].position_mm - alone.stroke.tips[i].position_mm)
                                  .norm(),
                              1e-9);
            }
            EXPECT_GT(both.strokes[1].stroke.tips.front().time,
                      both.strokes[0].stroke.tips.back().time);
        }
}

TEST(JoinedLogs, AreWarnedOfOnceWithTheLine)
{
    auto const first = part(5, 1000, true);
    auto const replayed = replay(head() + first + part(1, 3000, true));
    ASSERT_EQ(replayed.warnings.size(), 1u);
    auto const lines = std::count(first.begin(), first.end(), '\n');
    auto const head_text = head();
    auto const head_lines = std::count(head_text.begin(), head_text.end(), '\n');
    // The warning names the first report of the second part, the line after its D line.
    EXPECT_EQ(replayed.warnings[0],
              fmt::format("{}: the times go back by 4.496 s: another recording begins here, whose "
                          "times count on from the one before",
                          lines + head_lines + 2));
}

TEST(JoinedLogs, AreNotWhatIsOutOfOrderByALittle)
{
    auto text = head() + part(0, 1000, true);
    text += "D: 1\n" + line(0.45, height_report(1000));
    EXPECT_TRUE(replay(text).warnings.empty());
    EXPECT_EQ(replay(text).strokes.size(), 1u);
}

TEST(JoinedLogs, NeedNoSensorThatIsTheSame)
{
    // The second part is a new recording with the surface at another height. That must not count as
    // a jump.
    auto const log = drivers::parse_log(head() + part(5, 500, true) + part(0, 3900, true), "log");
    auto replay = LogReplay::create(*log, {}).value();
    replay.advance_to(Timestamp::max());
    EXPECT_TRUE(calib::describe_faults(replay.station().height_monitor(), log->begin()).empty());
}

} // namespace
} // namespace tractus::station
