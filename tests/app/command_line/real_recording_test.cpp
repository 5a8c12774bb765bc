#include "tests/app/command_line/workshop.h"
#include "tests/corpus.h"

#include <regex>

namespace tractus {
namespace {

// Fixture with recordings made by others with hid-recorder and their tablets.
class RealRecording : public Workshop {
protected:
    static std::string recording(char const* name)
    {
        std::string quoted = "'";
        quoted += (corpus() / "recordings" / name).string();
        return quoted += "'";
    }

    // Returns the number after `name` in the report of a command; -1 if there is none.
    static int figure(std::string const& report, std::string const& name)
    {
        std::smatch match;
        return std::regex_search(report, match, std::regex(name + " +(\\d+)")) ? std::stoi(match[1])
                                                                               : -1;
    }

    void expect_varied_plants(char const* name, std::string const& height)
    {
        auto const replay = "tractus replay " + recording(name) + " --plant small.l --count 2 ";
        auto const replayed = run(replay + "--height " + height + " -o out");
        ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
        EXPECT_GT(figure(replayed.out, "strokes"), 0);
        EXPECT_GT(figure(replayed.out, "branches selected"), 0);
        EXPECT_EQ(figure(replayed.out, "plants"), 2);
        EXPECT_EQ(count_files("out"), 6u);
        EXPECT_EQ(read("out/report.txt"), replayed.out);
    }
};

TEST_F(RealRecording, OfAHandOnAPenDisplayVariesAPlant)
{
    REQUIRE_CORPUS();
    expect_varied_plants("n-trig/n-trig_1b96_1000.hid", "sway");
}

TEST_F(RealRecording, OfAnHs610VariesAPlant)
{
    REQUIRE_CORPUS();
    expect_varied_plants("uclogic/Huion_HS610__dumps__default__pen_pressure__if1.hidrec", "rise");
}

TEST_F(RealRecording, OfADeco01VariesAPlant)
{
    REQUIRE_CORPUS();
    expect_varied_plants("uclogic/XP-Pen_Deco_01__dumps__pen_coords__if1.hidrec", "120");
}

TEST_F(RealRecording, NeedsAHeight)
{
    REQUIRE_CORPUS();
    expect_error(
        run("tractus replay " + recording("n-trig/n-trig_1b96_1000.hid") + " --plant small.l"), 1,
        "give the height with --height");
}

TEST_F(RealRecording, DecodesToTheColumnsThatOthersRead)
{
    REQUIRE_CORPUS();
    auto const decode = "tractus decode " + recording("n-trig/n-trig_1b96_1000.hid") + " --csv";
    auto const header = std::string("time_s,device,x_mm,y_mm,pressure,tilt_x_deg,tilt_y_deg,"
                                    "in_range,tip,eraser,buttons");
    auto const plain = run(decode).out;
    EXPECT_EQ(plain.substr(0, plain.find('\n')), header);
    auto const raw = run(decode + " --raw").out;
    EXPECT_EQ(raw.substr(0, raw.find('\n')), header + ",x_raw,y_raw,pressure_raw");
    auto const rows = std::count(plain.begin(), plain.end(), '\n') - 1;
    EXPECT_GT(rows, 1000);
    EXPECT_EQ(std::count(plain.begin(), plain.end(), ','), 10 * (rows + 1));
    EXPECT_EQ(std::count(raw.begin(), raw.end(), ','), 13 * (rows + 1));
}

} // namespace
} // namespace tractus
