#include "app/commands/window_look.h"
#include "engine/base/file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::commands {
namespace {

namespace fs = std::filesystem;

class WindowLookTest : public testing::Test {
protected:
    ~WindowLookTest() override
    {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_window_look_" + std::to_string(::getpid()));
    fs::path path_ = folder_ / "new" / "window.toml";
};

TEST_F(WindowLookTest, IsKeptFromOneTimeToTheNext)
{
    // The user has not chosen anything yet.
    EXPECT_EQ(load_look(path_).value(), window::WindowLook());
    for (bool const is_light : { true, false })
        for (bool const is_left_handed : { true, false }) {
            window::WindowLook const look { is_light, is_left_handed };
            ASSERT_TRUE(save_look(path_, look));
            EXPECT_EQ(load_look(path_).value(), look);
        }
}

TEST_F(WindowLookTest, KeepsHowFarStrokesHaveToGet)
{
    EXPECT_TRUE(load_min_extents(path_).value().empty());
    ASSERT_TRUE(save_look(path_, {}));
    EXPECT_TRUE(load_min_extents(path_).value().empty());
    ASSERT_TRUE(write_file(path_, "hand = \"left\"\nleast = \"draw=2.5 sketch=0\"\n"));
    tools::MinExtents const kept { { "draw", 2.5 }, { "sketch", 0 } };
    EXPECT_EQ(load_min_extents(path_).value(), kept);
    ASSERT_TRUE(save_look(path_, { .is_light = true })); // The user chooses the light look.
    EXPECT_EQ(load_min_extents(path_).value(), kept);
    EXPECT_TRUE(load_look(path_).value().is_light);
    ASSERT_TRUE(write_file(path_, "least = \"draw\"\n"));
    auto const wrong = load_min_extents(path_);
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.find("window.toml:1: least"), std::string::npos)
        << wrong.error().message;
}

TEST_F(WindowLookTest, SaysWhereAFileIsWrong)
{
    ASSERT_TRUE(save_look(path_, {}));
    auto const error_of = [&](std::string_view text) {
        EXPECT_TRUE(write_file(path_, text));
        auto const look = load_look(path_);
        EXPECT_FALSE(look);
        return look ? std::string() : look.error().message;
    };
    EXPECT_NE(error_of("colors = \"light\"\nhand = \"both\"\n").find("window.toml:2: hand"),
              std::string::npos);
    EXPECT_NE(error_of("hands = \"left\"\n").find("hands"), std::string::npos);
    // Settings that are missing in the file have their default values.
    ASSERT_TRUE(write_file(path_, "hand = \"left\"\n"));
    EXPECT_EQ(load_look(path_).value(), (window::WindowLook { .is_left_handed = true }));
}

} // namespace
} // namespace tractus::commands
