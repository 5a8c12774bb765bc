#include "drivers/logs/log.h"
#include "tests/app/command_line/workshop.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <initializer_list>
#include <span>
#include <string>

namespace tractus {
namespace {

class ConvertCommand : public Workshop { };

constexpr char const* kOurs = "D: 0\nR: 1 c0\nN: pen\nP: usb-1/input0\nI: 3 256c 006e\n"
                              "S: 201 HUION\nD: 1\nR: 0\nN: adc\nP: \nI: 1c 0000 0000\n"
                              "C: version = 1\n"
                              "T: 000000.000000 draw\nD: 0\nE: 000000.000000 2 01 02\n"
                              "G: 000000.500000\nD: 1\nE: 000001.000000 1 ff\n";

TEST_F(ConvertCommand, MakesWhatHidReplayPlays)
{
    write("ours.tractus-log", kOurs);
    auto const outcome = run("tractus convert ours.tractus-log -o pen.hid");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read("pen.hid"),
              "R: 1 c0\nN: pen\nP: usb-1/input0\nI: 3 256c 006e\nE: 000000.000000 2 01 02\n");
}

TEST_F(ConvertCommand, KeepsAllInOurOwnFormat)
{
    write("ours.tractus-log", kOurs);
    run("tractus convert ours.tractus-log -o again.tractus-log");
    EXPECT_EQ(read("again.tractus-log"), kOurs);
}

TEST_F(ConvertCommand, ReadsWhatUsbhidDumpPrints)
{
    write("dump.txt", "003:005:001:STREAM             1436110030.141241\n 07 80\n\n");
    auto const outcome = run("tractus convert dump.txt --ids 256c:006e -o pen.tractus-log");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "pen.tractus-log: 1 reports of 1 device as tractus-log\n");
    auto const log = drivers::parse_log(read("pen.tractus-log"), "pen").value();
    EXPECT_EQ(log.devices.at(0).product_id, 0x006e);
    EXPECT_EQ(log.records.size(), 1u);
}

TEST_F(ConvertCommand, ReadsWhatLibinputRecordWrites)
{
    write("record.yml",
          "version: 1\nndevices: 1\ndevices:\n- node: /dev/input/event5\n"
          "  evdev: {name: pen, id: [3, 1, 2, 3]}\n  hid: [0xc0]\n  events:\n"
          "  - hid:\n      time: [0, 1]\n      hidraw0: [ 0x01 ]\n");
    EXPECT_EQ(run("tractus convert record.yml -o pen.hid").exit_code, 0);
    EXPECT_EQ(read("pen.hid"), "R: 1 c0\nN: pen\nP: \nI: 3 0001 0002\nE: 000000.000000 1 01\n");
}

// Returns the input events of two pen strokes as text. `event` formats one event from its time in
// microseconds, type, code and value.
template<typename Event> std::string two_strokes(Event event)
{
    std::string text;
    int time_us = 1'000'000;
    auto const frame = [&](std::initializer_list<std::array<int, 3>> events) {
        for (auto const& [type, code, value] : events)
            text += event(time_us, type, code, value);
        text += event(time_us, 0, 0, 0);
        time_us += 5'000;
    };
    for (int stroke = 0; stroke < 2; ++stroke) {
        frame({ { 1, 320, 1 }, { 3, 0, 5'000 + 4'000 * stroke }, { 3, 1, 6'000 } });
        frame({ { 1, 330, 1 }, { 3, 24, 500 } });
        for (int i = 1; i < 100; ++i)
            frame({ { 3, 0, 5'000 + 4'000 * stroke + 20 * i }, { 3, 1, 6'000 - 30 * i } });
        frame({ { 1, 330, 0 }, { 3, 24, 0 } });
        frame({ { 1, 320, 0 } });
    }
    return text;
}

std::string evemu_of_two_strokes()
{
    std::string text = "# EVEMU 1.3\nN: Pen\nI: 0018 1b96 1000 0000\n";
    for (int i = 0; i < 5; ++i)
        text += "B: 01 00 00 00 00 00 00 00 00\n";
    text += "B: 01 01 04 00 00 00 00 00 00\nA: 00 0 20000 0 0 100\nA: 01 0 12000 0 0 100\n"
            "A: 18 0 1023 0 0 0\n";
    return text + two_strokes([](int time_us, int type, int code, int value) {
               return fmt::format("E: 13705985{:02}.{:06} {:04x} {:04x} {}\n", time_us / 1'000'000,
                                  time_us % 1'000'000, type, code, value);
           });
}

std::string libinput_record_of_two_strokes()
{
    return "version: 1\nndevices: 1\nlibinput: {version: 1}\ndevices:\n- node: /dev/input/event5\n"
           "  evdev:\n    name: Pen\n    id: [24, 7062, 4096, 0]\n"
           "    codes: {1: [320, 330], 3: [0, 1, 24]}\n    absinfo:\n"
           "      0: [0, 20000, 0, 0, 100]\n      1: [0, 12000, 0, 0, 100]\n"
           "      24: [0, 1023, 0, 0, 0]\n  events:\n  - evdev:\n"
        + two_strokes([](int time_us, int type, int code, int value) {
               return fmt::format("    - [{}, {}, {}, {}, {}]\n", time_us / 1'000'000,
                                  time_us % 1'000'000, type, code, value);
           });
}

// Returns the log as usbhid-dump would print it for a HID device.
std::string usbhid_dump_of(drivers::Log const& log)
{
    auto const block = [](char const* kind, double time_s, std::span<std::byte const> bytes) {
        std::string text = fmt::format("001:002:000:{}             {:.6f}\n", kind, time_s);
        for (auto const byte : bytes)
            text += fmt::format(" {:02X}", std::to_integer<int>(byte));
        return text + "\n\n";
    };
    auto text = block("DESCRIPTOR", 1, log.devices.at(0).report_descriptor);
    for (auto const& record : log.records)
        text += block("STREAM", 1370598501 + to_seconds(record.time), log.report(record));
    return text;
}

TEST_F(ConvertCommand, IsNotNeededToReadWhatOtherProgramsRecord)
{
    write("pen.ev", evemu_of_two_strokes());
    write("pen.yml", libinput_record_of_two_strokes());
    ASSERT_EQ(run("tractus convert pen.ev -o pen.tractus-log").exit_code, 0);
    write("pen.txt", usbhid_dump_of(drivers::parse_log(read("pen.tractus-log"), "pen").value()));
    auto const rows = run("tractus decode --csv pen.tractus-log");
    EXPECT_EQ(rows.exit_code, 0) << rows.err;
    EXPECT_EQ(std::ranges::count(rows.out, '\n'), 1 + 2 * 103);
    auto const strokes = run("tractus stream --strokes --height 120 pen.tractus-log");
    EXPECT_EQ(strokes.exit_code, 0) << strokes.err;
    for (std::string const file : { "pen.ev", "pen.yml", "pen.txt" }) {
        auto const decoded = run("tractus decode --csv " + file);
        EXPECT_EQ(decoded.exit_code, 0) << decoded.err;
        EXPECT_EQ(decoded.out, rows.out) << file;
        auto const streamed
            = run("cat " + file + " | tractus stream --strokes --height 120 /dev/stdin");
        EXPECT_EQ(streamed.out, strokes.out) << file << streamed.err;
        auto const examined = run("tractus doctor " + file);
        EXPECT_EQ(examined.exit_code, 0) << examined.out << examined.err;
    }
    auto const replayed
        = run("tractus replay pen.txt --plant small.l --height 120 --count 1 -o plants");
    EXPECT_EQ(replayed.exit_code, 0)
        << replayed.err << "its name is that of a file of strokes, too";
    EXPECT_NE(replayed.out.find("pen samples           206"), std::string::npos) << replayed.out;
}

TEST_F(ConvertCommand, SaysWhatItCannotDo)
{
    write("ours.tractus-log", kOurs);
    write("adc.tractus-log", "R: 0\nN: adc\nE: 0.0 1 01\n");
    expect_error(run("tractus convert ours.tractus-log -o ours.tractus-log"), 1,
                 "is the recording itself");
    expect_error(run("tractus convert adc.tractus-log -o adc.hid"), 1, "report descriptor");
    expect_error(run("tractus convert nothing.hid -o x.hid"), 1, "nothing.hid");
    expect_error(run("tractus convert ours.tractus-log -o x --to evemu"), 2, "'evemu'");
    expect_error(run("tractus convert ours.tractus-log -o x --ids huion"), 2, "256c:006e");
}

} // namespace
} // namespace tractus
