#include "app/commands/command_line.h"
#include "app/options/action.h"
#include "app/terminal/console.h"
#include "tests/app/methods/small_method/gust.h"

#include <array>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <memory>

namespace tractus::methods {
namespace {

void add_gust_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    auto strength = std::make_shared<double>(1);
    auto* const command = root.add_subcommand("gust", "Blow");
    command->add_option("--strength", *strength, "How much");
    command->callback([strength, count = methods.tools.size(), &action] {
        action = [strength, count] {
            return terminal::print_out(fmt::format("{} of {} tools\n", *strength, count));
        };
    });
}

TEST(SmallMethod, HasACommandWithAnOption)
{
    constexpr std::array<tools::AddCommand, 1> kCommands { add_gust_command };
    auto methods = methods_with_gust();
    methods.commands = kCommands;
    std::array const arguments { "tractus", "gust", "--strength", "2.5" };
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(
        commands::run_command_line(static_cast<int>(arguments.size()), arguments.data(), methods),
        0);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(),
              fmt::format("2.5 of {} tools\n", methods.tools.size()));
}

TEST(SmallMethod, IsListedByTheProgramsOwnCommands)
{
    std::array const arguments { "tractus", "tools", "gust" };
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(commands::run_command_line(3, arguments.data(), methods_with_gust()), 0);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(),
              "gust [towards_start] [strength=0.1..5]  (key G)\n    leans the plant along the "
              "stroke\n");
}

} // namespace
} // namespace tractus::methods
