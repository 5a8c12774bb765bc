#include "app/controllers/unnamed_session.h"

#include "app/batch/session_plant.h"
#include "app/controllers/drawing_name.h"
#include "engine/base/file.h"
#include "tests/app/small_model.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

namespace fs = std::filesystem;

class UnnamedSession : public ::testing::Test {
protected:
    void SetUp() override { ::setenv("XDG_DATA_HOME", folder_.c_str(), 1); }
    void TearDown() override
    {
        ::unsetenv("XDG_DATA_HOME");
        fs::remove_all(folder_);
    }

    fs::path path(std::string const& plant = "shrub") const
    {
        return unnamed_session_path(plant, std::chrono::sys_days(std::chrono::January / 9 / 2026))
            .value();
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_unnamed_" + std::to_string(::getpid()));
};

TEST_F(UnnamedSession, IsNamedAfterThePlantAndTheTime)
{
    EXPECT_EQ(path().parent_path(), folder_ / "tractus");
    EXPECT_TRUE(fs::is_directory(folder_ / "tractus"));
    // The file name has local time, so the time zone may change the day.
    EXPECT_EQ(path().filename().string().substr(0, 14), "shrub-2026-01-");
    EXPECT_EQ(path().extension(), ".tractus");
}

TEST(DrawingName, IsAPersonsElseThePlants)
{
    EXPECT_EQ(name_of_drawing("x/lombardy_poplar-2026-01-09-1403-2.tractus", ""),
              "Lombardy poplar");
    EXPECT_EQ(name_of_drawing("mine.tractus", ""), "Mine");
    EXPECT_EQ(name_of_drawing("mine.tractus", "Ash by the gate"), "Ash by the gate");
    EXPECT_EQ(name_as_typed("  Ash by the gate ").value(), "Ash by the gate");
    EXPECT_NE(name_as_typed("   ").error().message.find("at least one letter"), std::string::npos);
    EXPECT_FALSE(name_as_typed("two\nlines"));
    EXPECT_FALSE(name_as_typed(std::string(61, 'x')));
    EXPECT_EQ(file_name_of("oak/ash"), "oak-ash");
    EXPECT_EQ(file_name_of("../ash"), "-.-ash");
}

TEST_F(UnnamedSession, TakesNoNameThatIsTaken)
{
    auto const first = path();
    ASSERT_TRUE(write_file(first, std::string("1")));
    auto const second = path();
    EXPECT_EQ(second.filename().string(), first.stem().string() + "-2.tractus");
    ASSERT_TRUE(write_file(second, std::string("2")));
    EXPECT_EQ(path().filename().string(), first.stem().string() + "-3.tractus");
}

TEST_F(UnnamedSession, GoesAgainOnlyIfNothingWasDrawn)
{
    std::vector<scene::Edit> const beginning { small_model() };
    auto const empty = path("empty");
    ASSERT_TRUE(batch::begin_session(empty, beginning, scene::core_edit_kinds()));
    auto const drawn = path("drawn");
    {
        auto session = batch::begin_session(drawn, beginning, scene::core_edit_kinds()).value();
        std::vector<scene::Edit> const edits { scene::SetGrowth {} };
        ASSERT_TRUE(session.append(edits));
        ASSERT_TRUE(session.undo());
    }
    remove_if_nothing_was_drawn(empty);
    remove_if_nothing_was_drawn(drawn);
    EXPECT_FALSE(fs::exists(empty));
    EXPECT_TRUE(fs::exists(drawn)); // The stroke was undone, but it can be redone.
}

TEST_F(UnnamedSession, SaysWhereNoneCanBe)
{
    ASSERT_TRUE(write_file(folder_, std::string("no folder")));
    auto const path = unnamed_session_path("shrub", {});
    ASSERT_FALSE(path);
    EXPECT_NE(path.error().message.find("cannot make the folder"), std::string::npos);
    EXPECT_NE(path.error().message.find("give --session"), std::string::npos);
}

} // namespace
} // namespace tractus::controllers
