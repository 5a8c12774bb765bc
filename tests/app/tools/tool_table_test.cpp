#include "app/tools/tool_table.h"

#include "app/methods/all_methods.h"
#include "engine/base/file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace tractus::tools {
namespace {

TEST(ToolTable, StandsInTheManual)
{
    auto const page = std::filesystem::path(TRACTUS_MANUAL) / "drawing.md";
    auto const table = manual_table(methods::all_methods().tools);
    EXPECT_NE(read_file(page).value().find(table), std::string::npos)
        << page << " has another table of tools than this:\n"
        << table;
}

// The keys of the window itself are also taken: see show_shortcuts().
TEST(ToolTable, GivesNoKeyAndNoWordTwice)
{
    std::set<char> keys { 'T', 'V', 'F', 'W', 'S', 'Z', 'N', 'Q', '?' };
    std::set<std::string> words;
    for (auto const* const kind : methods::all_methods().tools) {
        EXPECT_TRUE(words.insert(kind->word).second) << kind->word;
        if (kind->key != 0) {
            EXPECT_TRUE(keys.insert(kind->key).second) << kind->key;
        }
    }
    EXPECT_EQ(words.size(), 41u);
}

TEST(ToolTable, SaysWhatMayStandBehindATool)
{
    auto const& kind = *find_tool_kind(methods::all_methods().tools, "draw");
    EXPECT_EQ(describe_tool(kind).substr(0, 38), "draw [descendants|both] [chord|world]\n");
}

} // namespace
} // namespace tractus::tools
