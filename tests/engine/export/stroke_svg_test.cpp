#include "engine/export/stroke_svg.h"

#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>
#include <sstream>

namespace tractus::exports {
namespace {

std::string svg_of(std::vector<Stroke> const& strokes, StrokeView view)
{
    std::ostringstream out;
    auto const written = write_strokes_svg(out, strokes, view);
    EXPECT_TRUE(written) << written.error().message;
    return out.str();
}

// Returns one stroke from the origin to a point 10 mm to the right, 20 mm away from the user and 30
// mm up.
std::vector<Stroke> one_line()
{
    return { stroke_of({ { 0, 0, 0 }, { 10, 20, 30 } }) };
}

std::string points_in(std::string const& svg)
{
    auto const begin = svg.find("points=\"") + 8;
    return svg.substr(begin, svg.find('"', begin) - begin);
}

TEST(StrokeSvg, SeesTheFrontTheSideAndTheTop)
{
    EXPECT_EQ(points_in(svg_of(one_line(), StrokeView::Front)), "0.000,0.000 10.000,-30.000");
    EXPECT_EQ(points_in(svg_of(one_line(), StrokeView::Side)), "0.000,0.000 20.000,-30.000");
    EXPECT_EQ(points_in(svg_of(one_line(), StrokeView::Top)), "0.000,0.000 10.000,-20.000");
}

TEST(StrokeSvg, IsAtTrueScale)
{
    EXPECT_EQ(
        svg_of(one_line(), StrokeView::Front),
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"20.000mm\" "
        "height=\"40.000mm\" viewBox=\"-5.000 -35.000 20.000 40.000\">\n"
        "<g fill=\"none\" stroke=\"#000000\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
        "<polyline id=\"stroke-1\" stroke-width=\"0.600\" points=\"0.000,0.000 10.000,-30.000\"/>\n"
        "</g>\n</svg>\n");
}

TEST(StrokeSvg, SaysThatTheDiskIsFull)
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    auto const written = write_strokes_svg(out, one_line(), StrokeView::Top);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().fault, Fault::User);
}

} // namespace
} // namespace tractus::exports
