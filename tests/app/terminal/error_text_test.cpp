#include "app/terminal/error_text.h"

#include "app/commands/command_line.h"
#include "app/methods/all_methods.h"
#include "engine/base/file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::terminal {
namespace {

namespace fs = std::filesystem;

class ErrorText : public ::testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directories(folder_);
        ASSERT_TRUE(write_file(path_, std::string("Lsystem: 1\nAxiom: A\nA\t--> F(\n")));
    }
    void TearDown() override { fs::remove_all(folder_); }

    Error error(std::string const& place) const
    {
        return { Fault::User, path_.string() + place + ": found nothing, expected a number" };
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_error_test_" + std::to_string(getpid()));
    fs::path const path_ = folder_ / "m.l";
};

TEST_F(ErrorText, SendsATerminalNothingThatAFileSays)
{
    for (auto const style : { ErrorStyle::Plain, ErrorStyle::Excerpt }) {
        EXPECT_EQ(error_text({ Fault::User, "no \x1b[2J\nhere" }, style),
                  "error: no \\x1b[2J\nhere\n");
        EXPECT_EQ(warning_text("\x1b]0;a\a", style), "warning: \\x1b]0;a\\x07\n");
    }
}

TEST_F(ErrorText, IsOneLineForPrograms)
{
    EXPECT_EQ(error_text(error(":3:9"), ErrorStyle::Plain),
              "error: " + path_.string() + ":3:9: found nothing, expected a number\n");
    EXPECT_EQ(error_text({ Fault::Device, "pen report 2" }, ErrorStyle::Colored),
              "\033[1;31mdevice error:\033[0m pen report 2\n");
}

TEST_F(ErrorText, IsTheSameForWarnings)
{
    EXPECT_EQ(warning_text("no leaves", ErrorStyle::Plain), "warning: no leaves\n");
    EXPECT_EQ(warning_text("no leaves", ErrorStyle::Colored),
              "\033[1;33mwarning:\033[0m no leaves\n");
    auto const excerpt = warning_text(error(":3:9").message, ErrorStyle::Excerpt);
    EXPECT_EQ(excerpt.substr(excerpt.find('\n')), "\n  A\t--> F(\n   \t      ^\n");
}

TEST_F(ErrorText, ShowsTheLineAndACaretUnderTheColumn)
{
    EXPECT_EQ(error_text(error(":3:9"), ErrorStyle::Excerpt),
              "error: " + path_.string()
                  + ":3:9: found nothing, expected a number\n"
                    "  A\t--> F(\n"
                    "   \t      ^\n");
}

TEST_F(ErrorText, ColorsPlaceAndCaret)
{
    EXPECT_EQ(error_text(error(":2:8"), ErrorStyle::Colored),
              "\033[1;31merror:\033[0m \033[1m" + path_.string()
                  + ":2:8\033[0m: found nothing, expected a number\n"
                    "  Axiom: A\n"
                    "         \033[1;32m^\033[0m\n");
}

TEST_F(ErrorText, LeavesOutAnExcerptOfWhatIsNotThere)
{
    auto const lines
        = [](std::string const& text) { return std::count(text.begin(), text.end(), '\n'); };
    EXPECT_EQ(lines(error_text(error(":99:1"), ErrorStyle::Excerpt)), 1);
    EXPECT_EQ(lines(error_text(error(":3"), ErrorStyle::Excerpt)), 1);
    EXPECT_EQ(lines(error_text({ Fault::User, "nowhere.l:1:1: no" }, ErrorStyle::Excerpt)), 1);
    EXPECT_EQ(lines(error_text({ Fault::User, "/dev/zero:1:1: no" }, ErrorStyle::Excerpt)), 1);
    EXPECT_EQ(lines(error_text(error(":3:500"), ErrorStyle::Excerpt)), 3);
}

TEST_F(ErrorText, HidesWhatATerminalWouldObey)
{
    ASSERT_TRUE(write_file(path_, std::string("Axiom: \033[2J(\n")));
    EXPECT_NE(error_text(error(":1:8"), ErrorStyle::Excerpt).find("Axiom: ?[2J(\n"),
              std::string::npos);
}

// Returns what the program prints to standard error if that is a terminal.
std::string printed_to_a_terminal(std::string const& model)
{
    int const terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_EQ(::grantpt(terminal), 0);
    EXPECT_EQ(::unlockpt(terminal), 0);
    std::array<char, 100> name {};
    EXPECT_EQ(::ptsname_r(terminal, name.data(), name.size()), 0);
    int const screen = ::open(name.data(), O_RDWR | O_NOCTTY);
    int const standard_error = ::dup(STDERR_FILENO);
    ::dup2(screen, STDERR_FILENO);
    std::array<char const*, 4> const arguments { "tractus", "derive", model.c_str(), "--string" };
    int const code = commands::run_command_line(static_cast<int>(arguments.size()),
                                                arguments.data(), methods::all_methods());
    ::dup2(standard_error, STDERR_FILENO);
    EXPECT_EQ(code, 1);
    std::array<char, 4096> text {};
    auto const length = ::read(terminal, text.data(), text.size());
    for (int const file : { terminal, screen, standard_error })
        ::close(file);
    return { text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)) };
}

// NOLINTBEGIN(concurrency-mt-unsafe): nothing else runs.
TEST_F(ErrorText, IsColoredOnATerminalOnly)
{
    ::setenv("TERM", "xterm", 1);
    ::unsetenv("NO_COLOR");
    auto const colored = printed_to_a_terminal(path_.string());
    EXPECT_NE(colored.find("\033[1m" + path_.string() + ":3:9\033[0m:"), std::string::npos)
        << colored;
    EXPECT_NE(colored.find("\033[1;32m^"), std::string::npos) << colored;
    ::setenv("NO_COLOR", "1", 1);
    auto const plain = printed_to_a_terminal(path_.string());
    EXPECT_EQ(plain.find('\033'), std::string::npos) << plain;
    EXPECT_NE(plain.find("A\t--> F("), std::string::npos) << plain;
    ::unsetenv("NO_COLOR");
}
// NOLINTEND(concurrency-mt-unsafe)

} // namespace
} // namespace tractus::terminal
