#include "app/tools/tool_choices.h"

#include "app/methods/all_methods.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/select_tool.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace tractus::tools {
namespace {

// Returns the texts of the buttons. The mark "|" precedes a button that begins a group. "!" follows
// a button that acts at once, and "*" follows the button that is on.
std::string buttons(Tool const& hand)
{
    std::string texts;
    for (auto const& meaning : meanings_of(methods::all_methods().tools, hand))
        texts += fmt::format("{}{}{}{}, ", meaning.begins_group ? "| " : "", meaning.text,
                             meaning.tool.is_done_at_once() ? "!" : "", meaning.is_on ? "*" : "");
    return texts;
}

TEST(ToolChoices, AreOneOfEachGroup)
{
    std::vector<Tool> const remembered { EraseTool { EraseTool::EraseExtent::Part } };
    auto const choices = tool_choices(methods::all_methods().tools, remembered);
    std::string texts;
    for (auto const& choice : choices)
        texts += fmt::format("{} ", choice.text);
    EXPECT_EQ(texts, "Draw Select Lean Erase Sketch Plants Picture ");
    EXPECT_EQ(choices[3].tool, remembered[0]);
}

TEST(ToolChoices, LeadBackToTheMethodThatWasInHandLast)
{
    auto const tools = methods::all_methods().tools;
    auto const& line = *find_tool_kind(tools, "construction_line");
    auto const two_nodes = with_number(Tool(line), 0, 2);
    std::vector<Tool> const remembered { Tool(*find_tool_kind(tools, "sketch")), two_nodes,
                                         Tool(*find_tool_kind(tools, "line_role")) };
    EXPECT_EQ(tool_choices(tools, remembered)[4].tool, two_nodes);
}

TEST(ToolChoices, OfferTheMethodsOfAGroupAndTheToolsOfOne)
{
    auto const tools = methods::all_methods().tools;
    EXPECT_EQ(
        buttons(Tool(*find_tool_kind(tools, "arrange"))),
        "Along a stroke, From an outline*, Growth brush, From lines, A leaf, | Go on, New tree, "
        "Carry a style, Split a bump, Join bumps, Leaf, Turn round, | To this tree!, Another one!, "
        "Crown in space, Erase in space, | Around the trunk*, Around branches, "
        "| Next!, Even!, Spiral!, "
        "Decussate!, Whorls!, Two rows!, Horizontal!, | In a whorl 3##whorl, Erase, ");
    EXPECT_EQ(
        buttons(Tool(*find_tool_kind(tools, "line_role"))),
        "Along a stroke, From an outline, Growth brush, From lines*, A leaf, | Line, Another "
        "stem, Another "
        "plant, | "
        "Next pattern!, Sizes around!, Turn organs!, Back to the pattern!, | Nodes of a "
        "layer, | It is an "
        "inclination*, Half of "
        "one, Left, Right, "
        "Around, Stem, No line, Outline, Turn round, | Leaf's edge, | Layer's organ, Erase, ");
}

// A number is entered in a panel, so its button must leave the current tool unchanged.
TEST(ToolChoices, AskForNumbers)
{
    Tool const hand(*find_tool_kind(methods::all_methods().tools, "sketch"));
    std::string asked;
    for (auto const& meaning : meanings_of(methods::all_methods().tools, hand))
        if (meaning.number) {
            EXPECT_EQ(meaning.tool, hand);
            asked += fmt::format("{} {}, ", *meaning.number, meaning.text);
        }
    EXPECT_EQ(asked,
              "0 Laterals 2##laterals, 1 Angle 50\u00b0##angle, 2 Internode 15 mm##first, "
              "3 Lengthening 0.95##ratio, 4 Lateral 0.7##lateral, ");
}

// The expected texts are those that the window had when each button was written by hand.
TEST(ToolChoices, OfferAllThatTheToolInHandMayMean)
{
    auto const tools = methods::all_methods().tools;
    EXPECT_EQ(
        buttons(Tool(*tools[0])),
        "Branch by branch*, | From its base*, Base to tip, As it lies, Selected, All it bears, "
        "Both, New limb, | Redraw, Smooth!, Turn round!, Take away!, ");
    EXPECT_EQ(
        buttons(DrawTool { variation::Propagation::Both, variation::StrokeFit::World }),
        "Branch by branch, Selected, All it bears, Both*, | From its base, Base to tip, As it "
        "lies*, New limb, | Redraw, Smooth!, Turn round!, Take away!, ");
    EXPECT_EQ(buttons(SelectTool {}),
              "Path*, By its ends, Add, Take, Whole order, All alike, | Invert!, Nothing!, ");
    EXPECT_EQ(
        buttons(Tool(*find_tool_kind(tools, "move_indicator"))),
        "Everywhere, Selected and above, Near it, | Wind, Light, | Move*, Turn round, Remove, ");
    EXPECT_EQ(buttons(EraseTool {}), "Whole strokes*, What it touches, ");
}

TEST(ToolChoices, KeepTheOtherOptionsOfTheToolInHand)
{
    auto const meanings
        = meanings_of(methods::all_methods().tools,
                      DrawTool { variation::Propagation::Both, variation::StrokeFit::World });
    EXPECT_EQ(meanings[2].tool,
              Tool(DrawTool { variation::Propagation::Descendants, variation::StrokeFit::World }));
    EXPECT_EQ(meanings[4].tool,
              Tool(DrawTool { variation::Propagation::Both, variation::StrokeFit::Start }));
}

} // namespace
} // namespace tractus::tools
