#include "app/station/log_replay.h"

#include "calib/rig_file.h"
#include "engine/plant/join_axes.h"
#include "tests/app/simulated_drawing.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

ReplayOptions on_small_model()
{
    ReplayOptions options;
    options.scene = small_scene();
    return options;
}

std::string refusal(Log const& log, ReplayOptions options = on_small_model())
{
    auto const replay = LogReplay::create(log, std::move(options));
    return replay ? "" : replay.error().message;
}

TEST(LogReplay, DoesWhatTheHandDid)
{
    auto const log = recorded_log();
    auto replay = LogReplay::create(log, on_small_model()).value();
    replay.run();
    auto const& scene = replay.station().scene();
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_EQ(scene.associations[0].path, segments_of(scene.base->axes[0]));
    EXPECT_EQ(scene.associations[0].propagation, Propagation::Both);
    ASSERT_EQ(scene.indicators.size(), 1u);
    EXPECT_NEAR((scene.indicators[0].end_mm - Vec3(30, 0, 110)).norm(), 0, 3);
    EXPECT_EQ(replay.station().counts().reports, log.records.size());
    EXPECT_EQ(replay.station().counts().broken_reports, 0u);
}

TEST(LogReplay, GivesTheSameInStepsAsAtOnce)
{
    auto const log = recorded_log();
    auto at_once = LogReplay::create(log, on_small_model()).value();
    at_once.run();
    auto in_steps = LogReplay::create(log, on_small_model()).value();
    auto time = in_steps.begin();
    while (in_steps.advance_to(time))
        time += std::chrono::milliseconds(17);
    ASSERT_EQ(in_steps.station().strokes().size(), at_once.station().strokes().size());
    for (std::size_t i = 0; i < at_once.station().strokes().size(); ++i) {
        auto const& one = at_once.station().strokes()[i].stroke.tips;
        auto const& other = in_steps.station().strokes()[i].stroke.tips;
        ASSERT_EQ(other.size(), one.size());
        EXPECT_EQ(other.back().position_mm, one.back().position_mm);
        EXPECT_EQ(other.back().time, one.back().time);
    }
}

TEST(LogReplay, FinishesOnce)
{
    auto const log = recorded_log();
    auto replay = LogReplay::create(log, on_small_model()).value();
    EXPECT_TRUE(replay.advance_to(replay.begin()));
    EXPECT_FALSE(replay.advance_to(replay.end()));
    EXPECT_FALSE(replay.advance_to(replay.end()));
    EXPECT_EQ(replay.station().counts().strokes, 3u);
}

TEST(LogReplay, WithoutToolsTheStrokesBendBranchAfterBranch)
{
    auto log = recorded_log();
    log.tools.clear();
    auto replay = LogReplay::create(log, on_small_model()).value();
    replay.run();
    EXPECT_EQ(replay.station().scene().associations.size(), 3u);
    EXPECT_TRUE(replay.station().scene().indicators.empty());
}

TEST(LogReplay, TakesAGivenHeightInPlaceOfTheSensors)
{
    auto const log = recorded_log();
    auto options = on_small_model();
    options.height = parse_height_scenario("90").value();
    auto replay = LogReplay::create(log, options).value();
    replay.run();
    for (auto const& drawn : replay.station().strokes())
        for (auto const& tip : drawn.stroke.tips)
            ASSERT_NEAR(tip.position_mm.z(), 90, 1e-9);
}

TEST(LogReplay, TakesAGivenRigInPlaceOfTheLogs)
{
    auto const log = recorded_log();
    auto options = on_small_model();
    options.rig = parse_rig(log.rig_text, "rig").value();
    options.rig->height_model = LinearHeight { .mm_per_count = 0.1, .zero_counts = 1000 };
    auto replay = LogReplay::create(log, options).value();
    replay.run();
    ASSERT_FALSE(replay.station().strokes().empty());
    auto as_recorded = LogReplay::create(log, on_small_model()).value();
    as_recorded.run();
    EXPECT_GT(as_recorded.station().strokes()[0].stroke.tips.front().position_mm.z(),
              replay.station().strokes()[0].stroke.tips.front().position_mm.z() + 1);
}

TEST(LogReplay, SaysWhatALogLacks)
{
    auto const log = recorded_log();
    auto without_rig = log;
    without_rig.rig_text.clear();
    EXPECT_NE(refusal(without_rig).find("no calibration: give one with --rig"), std::string::npos);
    auto with_odd_tool = log;
    with_odd_tool.tools[1].tool = "hammer";
    EXPECT_NE(refusal(with_odd_tool).find("there is no tool \"hammer\""), std::string::npos);
    auto with_odd_rig = log;
    with_odd_rig.rig_text = "version = 1\n";
    EXPECT_NE(refusal(with_odd_rig), "");
}

TEST(LogReplay, OfAnEmptyLogIsOverAtOnce)
{
    auto log = recorded_log();
    log.records.clear();
    log.tools.clear();
    auto replay = LogReplay::create(log, on_small_model()).value();
    EXPECT_EQ(replay.begin(), replay.end());
    EXPECT_FALSE(replay.advance_to(replay.begin()));
    EXPECT_TRUE(replay.station().strokes().empty());
}

} // namespace
} // namespace tractus
