#pragma once

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/construction_lines/line_tool.h"
#include "tests/app/simulated_drawing.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::lines::line_tests {

inline std::string line_of(tools::Tool const& tool)
{
    auto const words = tools::words_for(tool);
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tool);
    return words.name + " " + words.arguments;
}

// Returns the strokes of a frond: a stem, both boundaries, and two inclination lines.
inline std::vector<Stroke> frond()
{
    return { stroke_through({ { -40, -60, 50 }, { -42, 0, 50 }, { -36, 60, 50 } }),
             stroke_through({ { -70, -62, 50 }, { -75, 0, 50 }, { -55, 68, 50 } }),
             stroke_through({ { -15, -58, 50 }, { -10, 10, 50 }, { -18, 70, 50 } }),
             stroke_through({ { -90, -30, 50 }, { -41, -45, 50 }, { 0, -20, 50 } }),
             stroke_through({ { -80, 70, 50 }, { -38, 35, 50 }, { 5, 72, 50 } }) };
}

inline tools::Tool spiral(double nodes = 6)
{
    return LineTool { .nodes = nodes, .pattern = lines::Pattern::Kind::Spiral };
}

inline void draw_frond(document::Document& document)
{
    for (auto const& stroke : frond())
        document.draw({ stroke, spiral() });
}

} // namespace tractus::lines::line_tests
