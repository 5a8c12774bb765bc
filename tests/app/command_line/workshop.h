#pragma once

#include "tests/file_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace tractus {

// Outcome of a shell command. The exit code is the shell's: if a signal ended the command, it is
// 128 plus the number of the signal.
struct CommandOutcome {
    int exit_code = 0;
    std::string out {};
    std::string err {};
};

// Fixture with an almost empty folder in which shell commands run, with the program as `tractus`.
// The folder contains:
// small.l    a model with a trunk and two branches
// hand.toml  a script of a hand that shapes the trunk and leans the plant
class Workshop : public testing::Test {
protected:
    void SetUp() override
    {
        // Removes files that a killed process with the same process number may have left.
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        write("small.l",
              "Lsystem: 1\nderivation length: 1\n"
              "Axiom: F(10)F(10)[+(60)F(8)F(8)]F(10)[-(60)F(8)F(8)F(8)F(8)]F(10)\n"
              "A --> A\nendlsystem\n");
        write("hand.toml",
              "version = 1\nseed = 3\n"
              "[[gesture]]\ntool = \"select\"\ntrace = \"axis\"\naxis = 0\n"
              "[[gesture]]\ntool = \"draw\"\npropagation = \"both\"\npath = \"line\"\n"
              "from_mm = [0, 0, 50]\nto_mm = [40, 20, 200]\n"
              "[[gesture]]\ntool = \"indicate\"\npath = \"line\"\n"
              "from_mm = [0, 0, 100]\nto_mm = [30, 0, 110]\n");
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    // Runs a command line as a user would type it.
    CommandOutcome run(std::string const& command) const
    {
        auto const script = "cd '" + folder_.string() + "' && tractus() { '" TRACTUS_PROGRAM
            + "' \"$@\"; } && { " + command + "\n} >'" + outside("out") + "' 2>'" + outside("err")
            + "'";
        int const status = std::system(script.c_str());
        CommandOutcome outcome { WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                                 file_bytes(outside("out")), file_bytes(outside("err")) };
        std::filesystem::remove(outside("out"));
        std::filesystem::remove(outside("err"));
        return outcome;
    }

    // Writes a recording of the hand, "hand.tractus-log". It is made only once for all tests of a
    // process.
    void record() const
    {
        static std::string recording;
        if (!recording.empty()) {
            write("hand.tractus-log", recording);
            return;
        }
        auto const outcome
            = run("tractus record --simulate hand.toml --plant small.l -o hand.tractus-log");
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        recording = read("hand.tractus-log");
    }

    void write(std::string const& name, std::string const& text) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }

    std::filesystem::path path(std::string const& name) const { return folder_ / name; }

    std::string read(std::string const& name) const { return file_bytes(folder_ / name); }

    bool exists(std::string const& name) const { return std::filesystem::exists(folder_ / name); }

    // Returns the number of files in a folder.
    std::size_t count_files(std::string const& name) const
    {
        auto const entries = std::filesystem::directory_iterator(folder_ / name);
        return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
    }

private:
    // Returns a path outside the folder, so that files there are not counted among the commands'
    // output.
    std::string outside(char const* name) const { return folder_.string() + "." + name; }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path()
        / ("tractus_workshop_" + std::to_string(::getpid()));
};

// Expects a one-line error message that contains `what`.
inline void expect_error(CommandOutcome const& outcome, int exit_code, std::string const& what)
{
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("error: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

} // namespace tractus
