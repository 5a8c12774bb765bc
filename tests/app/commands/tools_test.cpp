#include "tests/app/commands/outcome.h"

namespace tractus::commands {
namespace {

TEST(ToolsCommand, ListsAllToolsOrOne)
{
    auto const all = run({ "tools" });
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(all.out.substr(0, 38), "draw_in_order [chord|world]  (key D)\n ");
    auto const one = run({ "tools", "erase" });
    EXPECT_EQ(one.out.substr(0, 22), "erase [part]  (key E)\n");
}

TEST(ToolsCommand, RefusesWhatIsNone)
{
    auto const outcome = run({ "tools", "hammer" });
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("hammer"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace tractus::commands
