#include "tests/app/command_line/workshop.h"

#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus {
namespace {

class PictureSize : public Workshop {
protected:
    // Returns the width and height in the header of a PNG, or zeros for any other file.
    std::pair<int, int> size_of(std::string const& name) const
    {
        auto const bytes = read(name);
        if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0)
            return {};
        auto const number = [&](std::size_t at) {
            int value = 0;
            for (std::size_t i = at; i < at + 4; ++i)
                value = 256 * value + static_cast<unsigned char>(bytes[i]);
            return value;
        };
        return { number(16), number(20) };
    }
};

// Every command that draws plants takes --size, as two numbers or as one for both.
TEST_F(PictureSize, IsAskedForInOneWayEverywhere)
{
    record();
    write("line.txt", "0 0 0\n0 0 40\n2 0 80\n");
    write("tree.json",
          R"({"trunk": [[0, 0], [0, 60]],
              "outline": [[0, 20], [-20, 25], [-30, 40], [-28, 60], [-20, 80], [0, 88], [20, 80],
                          [28, 60], [30, 40], [20, 25], [0, 20]]})");
    write("herb.json", R"({"strokes": [[[0, 0], [0, 100]], [[-10, 0], [-30, 50], [-10, 100]]]})");
    struct Case {
        char const* command;
        char const* picture;
    };
    constexpr std::array kCases {
        Case { "grow small.l -o grown.png", "grown.png" },
        Case { "grow --habit birch --years 3 -o habit.png", "habit.png" },
        Case { "sketch line.txt -o sketch", "sketch/line.png" },
        Case { "silhouette tree.json -o tree.png", "tree.png" },
        Case { "construct herb.json -o herb.png", "herb.png" },
        Case { "brush line.txt --years 2 -o brush.png", "brush.png" },
        Case { "leaves draw beech -o leaf.png", "leaf.png" },
        Case { "replay hand.tractus-log --plant small.l --count 1 -o replayed",
               "replayed/varied.png" },
    };
    for (auto const& [command, picture] : kCases) {
        SCOPED_TRACE(command);
        auto const wide = run(fmt::format("tractus {} --size 96x64", command));
        EXPECT_EQ(wide.exit_code, 0) << wide.err;
        EXPECT_EQ(size_of(picture), std::pair(96, 64));
        auto const square = run(fmt::format("tractus {} --size 80", command));
        EXPECT_EQ(square.exit_code, 0) << square.err;
        EXPECT_EQ(size_of(picture), std::pair(80, 80));
    }
}

TEST_F(PictureSize, IsThatOfEachPictureOnASheet)
{
    auto const small = run("tractus vary small.l --count 4 -o a --sheet small.png --size 60x90");
    ASSERT_EQ(small.exit_code, 0) << small.err;
    auto const large = run("tractus vary small.l --count 4 -o b --sheet large.png --size 160x190");
    ASSERT_EQ(large.exit_code, 0) << large.err;
    auto const [width, height] = size_of("small.png");
    auto const [wider, higher] = size_of("large.png");
    // Both sheets have as many columns and rows, each 100 pixels wider and higher.
    EXPECT_EQ((wider - width) % 100, 0);
    EXPECT_EQ((higher - height) % 100, 0);
    EXPECT_GT(wider, width);
}

TEST_F(PictureSize, IsNotThePlantsSizes)
{
    auto const old = run("tractus vary small.l --count 2 -o a --sheet a.png --size 0.4");
    expect_error(old, 2, "WIDTHxHEIGHT");
    EXPECT_NE(old.err.find("--sizes"), std::string::npos) << old.err;
    expect_error(run("tractus grow small.l -o a.png --size 9000"), 2, "16 to 8192");
}

} // namespace
} // namespace tractus
