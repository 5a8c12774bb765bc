#include "app/play/simulated_recording.h"

#include "tests/app/simulated_drawing.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::play {
namespace {

TEST(SimulatedRecording, HasTwoDevicesARigAndAToolForEachGesture)
{
    auto const log = recorded_log();
    EXPECT_EQ(log.warning_count, 0u) << drivers::summarize_warnings(log);
    EXPECT_EQ(log.devices.size(), 2u);
    EXPECT_NE(log.rig_text.find("[height]"), std::string::npos);
    ASSERT_EQ(log.tools.size(), 3u);
    EXPECT_EQ(log.tools[0].tool, "select");
    EXPECT_EQ(log.tools[1].tool, "draw");
    EXPECT_EQ(log.tools[1].arguments, "both heading from_foot") << "as a person draws now";
    EXPECT_EQ(log.tools[2].tool, "indicate");
}

TEST(SimulatedRecording, HasTheToolsOfOlderLogsWhereItsScriptSaysSo)
{
    std::string older(kTrunkAndWind);
    older.replace(older.find("seed = 3"), 8, "seed = 3\ntools = \"older\"");
    auto const log = recorded_log(older);
    EXPECT_EQ(log.tools[1].arguments, "both");
    EXPECT_EQ(log.records, recorded_log().records);
}

TEST(SimulatedRecording, IsInOrderOfArrival)
{
    auto const log = recorded_log();
    EXPECT_TRUE(std::is_sorted(log.records.begin(), log.records.end(),
                               [](auto const& a, auto const& b) { return a.time < b.time; }));
}

TEST(SimulatedRecording, IsTheSameTwiceAndAnotherWithAnotherSeed)
{
    auto const first = recorded(kTrunkAndWind).value();
    EXPECT_EQ(recorded(kTrunkAndWind).value(), first);
    std::string other(kTrunkAndWind);
    other.replace(other.find("seed = 3"), 8, "seed = 4");
    EXPECT_NE(recorded(other).value(), first);
}

TEST(SimulatedRecording, NamesABranchThatThePlantDoesNotHave)
{
    std::string script(kTrunkAndWind);
    script.replace(script.find("axis = 0"), 8, "axis = 3");
    auto const refused = recorded(script);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("the plant has no branch 3: it has 3"),
              std::string::npos)
        << refused.error().message;
}

TEST(SimulatedRecording, NamesWhatTheRigCannotReach)
{
    std::string script(kTrunkAndWind);
    script.replace(script.find("[40, 20, 200]"), 13, "[4000, 0, 20]");
    EXPECT_FALSE(recorded(script));
}

} // namespace
} // namespace tractus::play
