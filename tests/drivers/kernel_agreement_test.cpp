// Compares decoded reports of an N-trig pen display with an independent reference: the input events
// that Linux 3.10 made from the same drawing, recorded by evemu.

#include "drivers/logs/log.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/file.h"
#include "tests/corpus.h"
#include "tests/drivers/decode_one.h"

#include <charconv>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace tractus::drivers {
namespace {

// A pen state: x and y in counts, and whether the tip touches.
using State = std::tuple<std::int32_t, std::int32_t, bool>;

// Returns the states after each EV_SYN in an evemu file. Its lines are "E: <time> <type> <code>
// <value>", with type and code hexadecimal and value decimal.
std::set<State> kernel_states(std::string const& text)
{
    constexpr int kSync = 0, kKey = 1, kAbsolute = 3;
    constexpr int kAbsoluteX = 0, kAbsoluteY = 1, kTouch = 0x14A;
    std::set<State> states;
    State now {};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("E:"))
            continue;
        std::istringstream words(line.substr(2));
        double seconds = 0;
        int type = 0;
        int code = 0;
        int value = 0;
        words >> seconds >> std::hex >> type >> code >> std::dec >> value;
        if (type == kAbsolute && code == kAbsoluteX)
            std::get<0>(now) = value;
        if (type == kAbsolute && code == kAbsoluteY)
            std::get<1>(now) = value;
        if (type == kKey && code == kTouch)
            std::get<2>(now) = value != 0;
        if (type == kSync)
            states.insert(now);
    }
    return states;
}

std::set<State> our_states(Log const& log)
{
    auto decoder = make_pen_decoder(log.devices.front());
    EXPECT_TRUE(decoder);
    std::set<State> states;
    for (auto const& record : log.records) {
        auto const sample = decode_one(**decoder, record.time, log.report(record));
        EXPECT_TRUE(sample) << sample.error().message;
        if (!sample || !*sample)
            continue;
        // In this recording the kernel's BTN_TOUCH means only the tip, so touches of the eraser are
        // excluded.
        auto const& pen = **sample;
        states.insert({ pen.raw_x, pen.raw_y, pen.touching && !pen.eraser });
    }
    return states;
}

TEST(KernelAgreement, SeesTheSameStatesOfAnNtrigPen)
{
    REQUIRE_CORPUS();
    auto const folder = corpus() / "recordings" / "n-trig";
    auto const log = read_log(folder / "n-trig_1b96_1000.hid");
    ASSERT_TRUE(log) << log.error().message;
    auto const events = read_file(folder / "n-trig_1b96_1000.pen.kernel-3.10.ev");
    ASSERT_TRUE(events);

    auto const kernel = kernel_states(*events);
    auto const ours = our_states(*log);
    EXPECT_GT(kernel.size(), 1000u);
    for (auto const& [x, y, tip] : kernel)
        EXPECT_TRUE(ours.contains({ x, y, tip }))
            << "only the kernel: " << x << ' ' << y << ' ' << tip;
    for (auto const& [x, y, tip] : ours)
        EXPECT_TRUE(kernel.contains({ x, y, tip })) << "only here: " << x << ' ' << y << ' ' << tip;
    RecordProperty("states", static_cast<int>(kernel.size()));

    // The kernel's events can also be read as a recording.
    auto const recorded = read_log(folder / "n-trig_1b96_1000.pen.kernel-3.10.ev");
    ASSERT_TRUE(recorded) << recorded.error().message;
    auto const replayed = our_states(*recorded);
    auto const is_there = [](auto const& states, State const& state) {
        // States before the pen's first position are ignored.
        return states.contains(state) || std::get<1>(state) == 0;
    };
    for (auto const& state : replayed)
        EXPECT_TRUE(is_there(kernel, state)) << std::get<0>(state) << ' ' << std::get<1>(state);
    for (auto const& state : kernel)
        EXPECT_TRUE(is_there(replayed, state)) << std::get<0>(state) << ' ' << std::get<1>(state);
}

} // namespace
} // namespace tractus::drivers
