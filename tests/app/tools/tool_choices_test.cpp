#include "app/tools/tool_choices.h"

#include "app/methods/all_methods.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace tractus {
namespace {

// The texts of the buttons, "|" before those that begin a group, "!" behind those that are done at
// once, "*" behind that which is on.
std::string buttons(Tool const& hand)
{
    std::string texts;
    for (auto const& meaning : meanings_of(all_methods().tools, hand))
        texts += fmt::format("{}{}{}{}, ", meaning.begins_group ? "| " : "", meaning.text,
                             meaning.tool.is_done_at_once() ? "!" : "", meaning.is_on ? "*" : "");
    return texts;
}

TEST(ToolChoices, AreOneOfEachGroup)
{
    std::vector<Tool> const remembered { EraseTool { EraseTool::Erasing::Part } };
    auto const choices = tool_choices(all_methods().tools, remembered);
    std::string texts;
    for (auto const& choice : choices)
        texts += fmt::format("{} ", choice.text);
    EXPECT_EQ(texts, "Draw Select Lean Erase Sketch Outline Lines Plants ");
    EXPECT_EQ(choices[3].tool, remembered[0]);
}

// As the window had them when each was written out.
TEST(ToolChoices, OfferAllThatTheToolInHandMayMean)
{
    auto const tools = all_methods().tools;
    EXPECT_EQ(buttons(Tool(*tools[0])),
              "Branch by branch*, Selected, All it bears, Both, | Redraw, Smooth!, Take away!, ");
    EXPECT_EQ(
        buttons(DrawTool { Propagation::Both, StrokeFit::World }),
        "Branch by branch, Selected, All it bears, Both*, | From its base, Base to tip, As it "
        "lies*, | Redraw, Smooth!, Take away!, ");
    EXPECT_EQ(buttons(SelectTool {}),
              "Path*, By its ends, Add, Take, Whole order, All alike, | Invert!, Nothing!, ");
    EXPECT_EQ(buttons(Tool(*find_tool_kind(tools, "move_indicator"))),
              "Everywhere, Selected and above, Near it, | Wind, Light, | Move*, Remove, ");
    EXPECT_EQ(buttons(EraseTool {}), "Whole strokes*, What it touches, ");
}

TEST(ToolChoices, KeepTheOtherOptionsOfTheToolInHand)
{
    auto const meanings
        = meanings_of(all_methods().tools, DrawTool { Propagation::Both, StrokeFit::World });
    EXPECT_EQ(meanings[2].tool, Tool(DrawTool { Propagation::Descendants, StrokeFit::World }));
    EXPECT_EQ(meanings[4].tool, Tool(DrawTool { Propagation::Both, StrokeFit::Start }));
}

} // namespace
} // namespace tractus
