#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/tool_cards.h"

#include <gtest/gtest.h>

namespace tractus::tools {
namespace {

TEST(ToolCards, AreOfTheKindsThatSaySo)
{
    EXPECT_STREQ(cards_label(sketch::SketchTool::kKind), "Rule");
    EXPECT_STREQ(cards_label(silhouette::OutlineTool::kKind), "Form");
    EXPECT_EQ(cards_label(DrawTool::kKind), nullptr);
    auto const cards = ready_cards(Tool(sketch::SketchTool {}));
    ASSERT_EQ(cards.size(), 17u);
    EXPECT_EQ(cards[0].name, "Opposite");
    EXPECT_EQ(cards[0].tool, Tool(sketch::SketchTool {}));
    EXPECT_TRUE(ready_cards(Tool(DrawTool {})).empty());
}

TEST(ToolCards, LeaveWordsAsTheyAreInTheHand)
{
    sketch::SketchTool kept { .laterals = 5, .leaves = sketch::Leaves::Bare };
    kept.place = sketch::SketchTool::Place::Branch;
    kept.lateral_width = 0.3;
    sketch::SketchTool hand;
    hand.surface = StrokeSurface::Paper;
    auto const taken = *with_card(Tool(hand), card_of(Tool(kept))).get<sketch::SketchTool>();
    EXPECT_EQ(taken.laterals, 5);
    EXPECT_EQ(taken.lateral_width, 0.3);
    EXPECT_EQ(taken.leaves, sketch::Leaves::Leafy);
    EXPECT_EQ(taken.place, sketch::SketchTool::Place::Ground);
    EXPECT_EQ(taken.surface, StrokeSurface::Paper);
}

TEST(ToolCards, AreReadAsTheyWereWritten)
{
    auto const tools = methods::all_methods().tools;
    sketch::SketchTool tool { .card = sketch::SketchTool::Card::Fern,
                              .laterals = 3,
                              .angle_deg = 61.5,
                              .first_length_mm = 30,
                              .length_ratio = 0.9,
                              .lateral_length = 0.62 };
    tool.place = sketch::SketchTool::Place::Branch;
    auto const text = card_text(Tool(tool));
    EXPECT_EQ(text,
              "# A card of tractus: a tool and how it is set.\nsketch fern laterals=3 angle=61.5 "
              "at_foot\n");
    EXPECT_EQ(parse_card(tools, text, "x").value(), card_of(Tool(tool)));
    EXPECT_EQ(parse_card(tools, card_text(Tool(sketch::SketchTool {})), "x").value(),
              Tool(sketch::SketchTool {}));
    EXPECT_EQ(parse_card(tools, "\n# a\n# b\nsketch whorls angle=20 at_foot\r\nmore\n", "x")
                  .value()
                  .get<sketch::SketchTool>()
                  ->angle_deg,
              20);
}

TEST(ToolCards, RefuseOtherTexts)
{
    auto const tools = methods::all_methods().tools;
    auto const why = [&](char const* text) {
        auto const card = parse_card(tools, text, "my.card");
        return card ? std::string() : card.error().message;
    };
    for (auto const* text : { "", "#", "# only", "\n\n", "sketch laterals=90", "scetch", "draw" })
        EXPECT_TRUE(why(text).starts_with("my.card: ")) << text << ": " << why(text);
    EXPECT_NE(why("draw").find("without cards"), std::string::npos);
}

} // namespace
} // namespace tractus::tools
