#include "drivers/logs/log.h"
#include "tests/app/command_line/workshop.h"

#include <gtest/gtest.h>

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
