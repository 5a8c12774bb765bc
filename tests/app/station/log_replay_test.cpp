#include "app/methods/all_methods.h"
#include "app/station/log_replay.h"

#include "calib/rig_file.h"
#include "engine/plant/join_axes.h"
#include "tests/app/replayed.h"
#include "tests/app/simulated_drawing.h"

#include <gtest/gtest.h>

namespace tractus::station {
namespace {

std::string refusal(drivers::Log const& log)
{
    auto const replay = LogReplay::create(log, { .methods = methods::all_methods() });
    return replay ? "" : replay.error().message;
}

TEST(LogReplay, DoesWhatTheHandDid)
{
    auto const log = recorded_log();
    auto const [counts, scene, strokes] = replayed(log);
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_EQ(scene.associations[0].what.path, segments_of(scene.base->axes[0]));
    EXPECT_EQ(scene.associations[0].what.propagation, variation::Propagation::Both);
    EXPECT_EQ(scene.associations[0].what.laying, variation::StrokeLaying::HeadingAndPitch);
    ASSERT_EQ(scene.indicators.size(), 1u);
    EXPECT_NEAR((scene.indicators[0].what.end_mm - Vec3(30, 0, 110)).norm(), 0, 3);
    EXPECT_EQ(counts.reports, log.records.size());
    EXPECT_EQ(counts.broken_reports, 0u);
}

TEST(LogReplay, LaysTheStrokesOfOlderLogsAsTheyWereLaid)
{
    auto log = recorded_log();
    log.tools[1].arguments = "both";
    auto const older = replayed(log).scene;
    ASSERT_EQ(older.associations.size(), 1u);
    EXPECT_EQ(older.associations[0].what.laying, variation::StrokeLaying::LeastTwist);
    // Without tool lines, the log uses the default tool, which draws branch by branch.
    log.tools.clear();
    auto const without = replayed(log).scene;
    ASSERT_EQ(without.associations.size(), 3u);
    for (std::size_t i = 0; i < without.associations.size(); ++i)
        EXPECT_EQ(without.associations[i].what.laying, variation::StrokeLaying::LeastTwist);
}

TEST(LogReplay, GivesTheSameInStepsAsAtOnce)
{
    auto const log = recorded_log();
    auto const at_once = replayed(log).strokes;
    auto replay = LogReplay::create(log, { .methods = methods::all_methods() }).value();
    auto time = replay.begin();
    while (replay.advance_to(time))
        time += std::chrono::milliseconds(17);
    auto const in_steps = replay.station().take_strokes();
    ASSERT_EQ(in_steps.size(), at_once.size());
    for (std::size_t i = 0; i < at_once.size(); ++i) {
        auto const& one = at_once[i].stroke.tips;
        auto const& other = in_steps[i].stroke.tips;
        ASSERT_EQ(other.size(), one.size());
        EXPECT_EQ(other.back().position_mm, one.back().position_mm);
        EXPECT_EQ(other.back().time, one.back().time);
    }
}

TEST(LogReplay, FinishesOnce)
{
    auto const log = recorded_log();
    auto replay = LogReplay::create(log, { .methods = methods::all_methods() }).value();
    EXPECT_TRUE(replay.advance_to(replay.begin()));
    EXPECT_FALSE(replay.advance_to(replay.end()));
    EXPECT_FALSE(replay.advance_to(replay.end()));
    EXPECT_EQ(replay.station().counts().strokes, 3u);
}

TEST(LogReplay, WithoutToolsTheStrokesBendBranchAfterBranch)
{
    auto log = recorded_log();
    log.tools.clear();
    auto const scene = replayed(log).scene;
    EXPECT_EQ(scene.associations.size(), 3u);
    EXPECT_TRUE(scene.indicators.empty());
}

TEST(LogReplay, TakesAGivenHeightInPlaceOfTheSensors)
{
    auto const log = recorded_log();
    ReplayOptions options { .methods = methods::all_methods() };
    options.height = calib::parse_height_scenario("90").value();
    for (auto const& drawn : replayed(log, options).strokes)
        for (auto const& tip : drawn.stroke.tips)
            ASSERT_NEAR(tip.position_mm.z(), 90, 1e-9);
}

TEST(LogReplay, TakesAGivenRigInPlaceOfTheLogs)
{
    auto const log = recorded_log();
    ReplayOptions options { .methods = methods::all_methods() };
    options.rig = calib::parse_rig(log.rig_text, "rig").value();
    options.rig->height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = 1000 };
    auto const strokes = replayed(log, options).strokes;
    ASSERT_FALSE(strokes.empty());
    EXPECT_GT(replayed(log).strokes[0].stroke.tips.front().position_mm.z(),
              strokes[0].stroke.tips.front().position_mm.z() + 1);
}

TEST(LogReplay, SaysWhatALogLacks)
{
    auto const log = recorded_log();
    auto without_rig = log;
    without_rig.rig_text.clear();
    EXPECT_NE(refusal(without_rig).find("no calibration: give one with --rig"), std::string::npos);
    auto with_odd_argument = log;
    with_odd_argument.tools[1].arguments = "twice";
    EXPECT_NE(refusal(with_odd_argument).find("twice"), std::string::npos);
    auto with_odd_step = log;
    with_odd_step.tools[1] = { log.tools[1].time, "undo", "often", log.tools[1].position };
    EXPECT_NE(refusal(with_odd_step).find("is not a step"), std::string::npos);
    auto with_odd_rig = log;
    with_odd_rig.rig_text = "version = 1\n";
    EXPECT_NE(refusal(with_odd_rig), "");
}

drivers::LogTool min_extents(std::string words, std::size_t position)
{
    return { {}, "least", std::move(words), position };
}

// The log has three strokes: one that selects, one that draws and one that indicates a motion.
TEST(LogReplay, LeavesOutStrokesThatGetLessFarThanTheLogSays)
{
    auto log = recorded_log();
    log.tools.insert(log.tools.begin(), min_extents("draw=10 indicate=100 hammer=3", 0));
    auto const [counts, scene, strokes] = replayed(log);
    EXPECT_EQ(counts.strokes, 2u);
    EXPECT_EQ(counts.dabs, 1u);
    EXPECT_EQ(scene.associations.size(), 1u);
    EXPECT_TRUE(scene.indicators.empty());
    log.tools[0].arguments = "draw=-1";
    EXPECT_NE(refusal(log).find("\"draw=-1\" is no least extent"), std::string::npos);
}

// The log was made by a program with more tools. A stroke with an unknown tool must change nothing;
// the other strokes must have their usual effect.
TEST(LogReplay, LeavesOutWhatItDoesNotKnowAndNamesIt)
{
    auto log = recorded_log();
    log.tools[1].tool = "hammer";
    auto replay = LogReplay::create(log, { .methods = methods::all_methods() }).value();
    ASSERT_EQ(replay.left_out().size(), 1u);
    EXPECT_NE(replay.left_out()[0].find("there is no tool \"hammer\""), std::string::npos);
    auto const [counts, scene, strokes] = replayed(log);
    EXPECT_EQ(counts.strokes, 3u);
    EXPECT_TRUE(scene.associations.empty());
    EXPECT_EQ(scene.indicators.size(), 1u);
    EXPECT_NE(strokes[1].refusal.find("does not know the tool"), std::string::npos);
}

drivers::LogTool undo_after(std::size_t strokes, drivers::Log const& log, std::size_t position)
{
    return { log.end(), "undo", std::to_string(strokes), position };
}

// In a log, the line of an undo step may come after reports of a later stroke, or before the end of
// an earlier stroke is known.
TEST(LogReplay, DoesStepsBetweenTheStrokesWhereTheyWereDone)
{
    auto log = recorded_log();
    auto const all = log.records.size();
    auto early = log;
    early.tools.push_back(undo_after(3, log, all / 2));
    EXPECT_TRUE(replayed(early).scene.indicators.empty()) << "the third stroke's";
    EXPECT_EQ(replayed(early).scene.associations.size(), 1u);
    auto late = log;
    late.tools.push_back(undo_after(2, log, all));
    EXPECT_TRUE(replayed(late).scene.associations.empty()) << "the second stroke's";
    EXPECT_EQ(replayed(late).scene.indicators.size(), 1u);
    auto twice = late;
    twice.tools.push_back({ log.end(), "redo", "2", all });
    EXPECT_EQ(replayed(twice).scene.associations.size(), 1u);
    EXPECT_EQ(replayed(twice).scene.indicators.size(), 1u);
}

TEST(LogReplay, OfAnEmptyLogIsOverAtOnce)
{
    auto log = recorded_log();
    log.records.clear();
    log.tools.clear();
    auto replay = LogReplay::create(log, { .methods = methods::all_methods() }).value();
    EXPECT_EQ(replay.begin(), replay.end());
    EXPECT_FALSE(replay.advance_to(replay.begin()));
    EXPECT_TRUE(replay.station().take_strokes().empty());
}

} // namespace
} // namespace tractus::station
