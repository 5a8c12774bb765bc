#include "engine/stroke/stroke_text.h"

#include "tests/corpus.h"
#include "tests/engine/stroke/corpus_strokes.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/file_bytes.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(StrokeText, ReadsATipPerLineAndAStrokePerParagraph)
{
    auto const strokes = parse_strokes("a.txt",
                                       "# two strokes\n0 0 0\n0,5,10 0.5\r\n\n\n"
                                       "1 2 3 0.25 40\n4;5;6;2;50 # pressed hard\n\n9 9 9\n");
    ASSERT_TRUE(strokes) << strokes.error().message;
    ASSERT_EQ(strokes->size(), 2u); // A single point is not a stroke.
    EXPECT_EQ((*strokes)[0].tips[1].position_mm, Vec3(0, 5, 10));
    EXPECT_EQ((*strokes)[0].tips[1].pressure, 0.5);
    EXPECT_EQ((*strokes)[0].tips[1].time, timestamp_ns(10'000'000));
    EXPECT_EQ((*strokes)[1].tips[0].time, timestamp_ns(40'000'000));
    EXPECT_EQ((*strokes)[1].tips[1].pressure, 1);
    EXPECT_TRUE((*strokes)[1].tips[1].touching);
}

TEST(StrokeText, SaysWhereAndWhatIsWrong)
{
    auto const error
        = [](char const* text) { return parse_strokes("a.txt", text).error().message; };
    EXPECT_EQ(error("0 0 0\n0 zero 0\n"), "a.txt:2: \"zero\" is not a number");
    EXPECT_EQ(error("0 0 nan\n"), "a.txt:1: \"nan\" is not a number");
    EXPECT_EQ(error("1 2\n"),
              "a.txt:1: 2 numbers do not make a point: give x y z, and if you like pressure and "
              "milliseconds");
    EXPECT_EQ(error("1 2 3\n1 2 3\n"),
              "a.txt: there is no stroke of two points in it: give a line \"x y z\" for each");
    EXPECT_FALSE(parse_strokes("a.txt", ""));
}

TEST(StrokeText, IsReadBackAsItWasPrinted)
{
    std::vector<Stroke> const strokes { stroke_of(trembling(s_curve(20), 1)),
                                        stroke_of({ { 0.1, -1e-7, 3 }, { 1e6, 2, 3 } }) };
    auto const text = print_strokes(strokes);
    EXPECT_EQ(text.substr(text.rfind("0.1 ")), "0.1 -1e-07 3 0.5 0\n1000000 2 3 0.5 5\n\n");
    auto const read = parse_strokes("strokes.txt", text);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->size(), 2u);
    for (std::size_t i = 0; i < 20; ++i) {
        auto const& tip = strokes[0].tips[i];
        EXPECT_EQ((*read)[0].tips[i].position_mm, tip.position_mm);
        EXPECT_EQ((*read)[0].tips[i].pressure, tip.pressure);
        EXPECT_EQ((*read)[0].tips[i].time, tip.time);
    }
}

TEST(StrokeText, ReadsWhatPeopleDrewInVirtualReality)
{
    for (char const* name : { "Wire.strokes.txt", "Blue_Tit.strokes.txt" }) {
        auto const path = shipped("strokes") / name;
        auto const strokes = parse_strokes(name, file_bytes(path));
        ASSERT_TRUE(strokes) << strokes.error().message;
        auto const expected = read_strokes(path);
        ASSERT_EQ(strokes->size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            ASSERT_EQ((*strokes)[i].tips.size(), expected[i].size());
            EXPECT_EQ((*strokes)[i].tips.back().position_mm, expected[i].back());
        }
    }
}

} // namespace
} // namespace tractus
