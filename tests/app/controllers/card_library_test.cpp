#include "app/controllers/card_library.h"
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::controllers {
namespace {

class CardLibraryTest : public testing::Test {
protected:
    CardLibraryTest() { std::filesystem::remove_all(folder_); }
    ~CardLibraryTest() override { std::filesystem::remove_all(folder_); }

    std::vector<tools::ToolCard> rules() const
    {
        return library_.cards_of(methods::all_methods().tools, sketch::SketchTool::kKind);
    }

    std::filesystem::path const folder_
        = std::filesystem::temp_directory_path() / fmt::format("tractus_cards_{}", ::getpid());
    CardLibrary const library_ { folder_ / "cards" };
};

TEST_F(CardLibraryTest, KeepsEachKindApartUnderNamesOfTheirOwn)
{
    EXPECT_TRUE(rules().empty()) << "there is no folder";
    EXPECT_EQ(library_.keep(tools::Tool(sketch::SketchTool { .laterals = 5 })).value(), "Rule 1");
    EXPECT_EQ(library_.keep(tools::Tool(sketch::SketchTool { .laterals = 6 })).value(), "Rule 2");
    EXPECT_EQ(library_.keep(tools::Tool(silhouette::OutlineTool {})).value(), "Form 1");
    auto const cards = rules();
    ASSERT_EQ(cards.size(), 2u);
    EXPECT_EQ(cards[0].name, "Rule 1");
    EXPECT_EQ(cards[0].tool, tools::Tool(sketch::SketchTool { .laterals = 5 }));
    EXPECT_EQ(
        library_.cards_of(methods::all_methods().tools, silhouette::OutlineTool::kKind).size(), 1u);
}

TEST_F(CardLibraryTest, CallsCardsOtherwiseAndTakesThemAway)
{
    ASSERT_TRUE(library_.keep(tools::Tool(sketch::SketchTool {})));
    ASSERT_TRUE(library_.keep(tools::Tool(sketch::SketchTool { .laterals = 3 })));
    EXPECT_TRUE(library_.rename("Rule 1", "Bergahorn, jung"));
    EXPECT_FALSE(library_.rename("Rule 2", "Bergahorn, jung")) << "it would be gone";
    EXPECT_TRUE(library_.rename("Rule 2", "Rule 2"));
    EXPECT_EQ(library_.keep(tools::Tool(sketch::SketchTool {})).value(), "Rule 1")
        << "the name is free again";
    ASSERT_EQ(rules().size(), 3u);
    EXPECT_EQ(rules()[0].name, "Bergahorn, jung");
    EXPECT_TRUE(library_.remove("Bergahorn, jung"));
    EXPECT_FALSE(library_.remove("Bergahorn, jung"));
    EXPECT_EQ(rules().size(), 2u);
}

TEST_F(CardLibraryTest, RefusesNamesThatLeadElsewhere)
{
    ASSERT_TRUE(library_.keep(tools::Tool(sketch::SketchTool {})));
    for (auto const* name : { "", "../Rule", "a/b", "a\\b", ".hidden", " a", "a ", "a\nb", "c:d" })
        EXPECT_FALSE(library_.rename("Rule 1", name)) << name;
    EXPECT_FALSE(library_.rename("Rule 1", std::string(61, 'a')));
    EXPECT_EQ(rules().size(), 1u);
}

TEST_F(CardLibraryTest, LeavesOutWhatIsNoCard)
{
    ASSERT_TRUE(library_.keep(tools::Tool(sketch::SketchTool {})));
    auto const write = [&](char const* name, std::string const& text) {
        std::ofstream(folder_ / "cards" / name) << text;
    };
    write("broken.card", "sketch laterals=many\n");
    write("newer.card", "sketch laterals=3 petals=5\n");
    write("large.card", std::string(100'000, '#'));
    write("other.txt", "sketch\n");
    std::filesystem::create_directory(folder_ / "cards" / "folder.card");
    EXPECT_EQ(rules().size(), 1u);
}

TEST(CardLibrary, SaysWhereNothingCanBeKept)
{
    EXPECT_NE(CardLibrary().keep(tools::Tool(sketch::SketchTool {})).error().message.find("HOME"),
              std::string::npos);
    EXPECT_FALSE(CardLibrary("/proc/none").keep(tools::Tool(sketch::SketchTool {})));
}

} // namespace
} // namespace tractus::controllers
