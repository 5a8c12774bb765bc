#include "tests/app/command_line/workshop.h"

#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tractus {
namespace {

constexpr long kMaxPeak_kB = 100'000;

// The memory needed to read a recording must depend neither on its size nor on the sizes stated in
// it.
class LargeLog : public Workshop {
protected:
    // Returns the peak memory of the programs that a command starts. The command runs in a child
    // process, since a process only knows the maximum over all its children so far.
    long peak_kB(std::string const& command, int exit_code = 0)
    {
        int ends[2] {};
        EXPECT_EQ(::pipe(ends), 0);
        auto const child = ::fork();
        if (child == 0) {
            bool const is_as_expected = run(command).exit_code == exit_code;
            rusage used {};
            ::getrusage(RUSAGE_CHILDREN, &used);
            long const peak = is_as_expected ? used.ru_maxrss : -1;
            ::_exit(::write(ends[1], &peak, sizeof peak) == sizeof peak ? 0 : 1);
        }
        long peak = -1;
        EXPECT_EQ(::read(ends[0], &peak, sizeof peak), static_cast<ssize_t>(sizeof peak));
        ::waitpid(child, nullptr, 0);
        ::close(ends[0]);
        ::close(ends[1]);
        EXPECT_GT(peak, 0) << command << ": " << read("err");
        return peak;
    }

    // Writes a log with the given number of copies of the reports in hand.tractus-log.
    void write_large(std::string const& name, int copies) const
    {
        std::string head;
        std::string body;
        std::istringstream lines(read("hand.tractus-log"));
        for (std::string line; std::getline(lines, line);) {
            bool const is_report = line.starts_with("E:") || line.starts_with("D:");
            if (!line.starts_with("T:"))
                (is_report || !body.empty() ? body : head) += line + "\n";
        }
        std::ofstream out(path(name));
        out << head;
        for (int i = 0; i < copies; ++i)
            out << body;
    }
};

TEST_F(LargeLog, TakesNoMoreMemoryThanASmallOne)
{
    record();
    auto const size = read("hand.tractus-log").size();
    ASSERT_GT(size, 10'000u);
    write_large("small.tractus-log", static_cast<int>(3'000'000 / size + 1));
    write_large("large.tractus-log", static_cast<int>(60'000'000 / size + 1));
    for (std::string const command :
         { "decode {}", "decode {} --csv -o out.csv", "convert {} -o out.hid", "doctor {}" }) {
        // The first run is discarded. The kernel maps pages of the program that are already in the
        // disk cache in groups, so the first run after a build maps fewer pages.
        peak_kB("tractus " + fmt::format(fmt::runtime(command), "small.tractus-log"));
        auto const of_small
            = peak_kB("tractus " + fmt::format(fmt::runtime(command), "small.tractus-log"));
        auto const of_large
            = peak_kB("tractus " + fmt::format(fmt::runtime(command), "large.tractus-log"));
        EXPECT_LT(of_large, of_small + 2'000) << command;
        EXPECT_LT(of_large, kMaxPeak_kB) << command;
    }
}

TEST_F(LargeLog, IsRefusedAtALineWithoutEnd)
{
    write("head", "R: 1 c0\nE: 0.1 1 ");
    run("{ cat head; head -c 200000000 /dev/zero | tr '\\0' 0; } >line.hid");
    for (std::string const command : { "decode line.hid", "convert line.hid -o out.hid",
                                       "decode /dev/zero", "convert /dev/zero -o out.hid" })
        EXPECT_LT(peak_kB("tractus " + command, 1), kMaxPeak_kB) << command;
}

TEST_F(LargeLog, OfAnotherProgramTakesNoMoreThanItsReports)
{
    {
        std::ofstream yaml(path("libinput.yml"));
        std::ofstream dump(path("dump.txt"));
        yaml << "ndevices: 1\ndevices:\n- node: /dev/input/event5\n  hid: [5, 13, 9, 2]\n  "
                "events:\n";
        for (int i = 0; i < 300'000; ++i) {
            yaml << fmt::format(
                "  - hid:\n      time: [{}, {}]\n      hidraw3: [\n        2, 128, 16\n"
                "      ]\n  - evdev:\n    - [{}, {}, 3, 0, 12] # EV_ABS\n",
                i / 200, i % 200 * 5000, i / 200, i % 200 * 5000);
            dump << fmt::format("003:005:001:STREAM   {}.{:06}\n 08 80 10 27\n\n", i / 200,
                                i % 200 * 5000);
        }
    }
    for (std::string const file : { "libinput.yml", "dump.txt" })
        EXPECT_LT(peak_kB("tractus convert " + file + " -o out.tractus-log"), kMaxPeak_kB) << file;
}

} // namespace
} // namespace tractus
