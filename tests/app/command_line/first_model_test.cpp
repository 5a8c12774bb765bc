#include "tests/app/command_line/workshop.h"

#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus {
namespace {

using FirstModel = Workshop;

// Returns the code blocks of the manual's page first-model.md that are not shell commands, in
// order.
std::vector<std::string> blocks_of_page()
{
    std::ifstream page(TRACTUS_MANUAL "/first-model.md");
    std::vector<std::string> blocks;
    bool is_inside = false;
    bool is_text = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) {
            is_inside = !is_inside;
            is_text = is_inside && line == "```";
            if (is_text)
                blocks.emplace_back();
        } else if (is_text) {
            blocks.back() += line + '\n';
        }
    }
    return blocks;
}

TEST_F(FirstModel, GrowsAtEachStepOfThePage)
{
    // Sizes of the plant at each step, as the page states them.
    std::vector<std::string> const drawn { "8 segments, 0 organs",     "36 segments, 0 organs",
                                           "152 segments, 0 organs",   "152 segments, 152 organs",
                                           "187 segments, 187 organs", "270 segments, 762 organs" };
    std::size_t step = 0;
    std::string view;
    auto const blocks = blocks_of_page();
    for (auto const& block : blocks)
        if (block.starts_with("Lsystem"))
            write(fmt::format("{}.l", ++step), block);
        else
            write(fmt::format("{}.v", step), view += block);
    ASSERT_EQ(step, drawn.size());
    for (step = 1; step <= drawn.size(); ++step) {
        auto const checked = run(fmt::format("tractus lsystem check {}.l", step));
        EXPECT_NE(checked.out.find("\nNo warnings\n"), std::string::npos)
            << checked.out << checked.err;
        auto const grown = run(fmt::format("tractus grow {0}.l -o {0}.obj", step));
        EXPECT_NE(grown.out.find(drawn[step - 1]), std::string::npos) << grown.out << grown.err;
    }
}

} // namespace
} // namespace tractus
