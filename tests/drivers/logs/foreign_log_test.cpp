#include "drivers/logs/foreign_log.h"

#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

Result<Log> parsed_dump(std::string const& text, std::string_view name)
{
    std::istringstream in(text);
    return parse_usbhid_dump(in, name);
}

Result<Log> parsed_record(std::string const& text, std::string_view name)
{
    std::istringstream in(text);
    return parse_libinput_record(in, name);
}

constexpr char const* kDump = "Starting dumping interrupt transfer stream\n"
                              "with 1 minute timeout.\n"
                              "\n"
                              "003:005:001:DESCRIPTOR         1436110023.141241\n"
                              " 05 0D 09 02 A1 01 85 07 09 20 A1 00 09 42 09 44\n"
                              " C0 C0\n"
                              "\n"
                              "003:005:001:STREAM             1436110030.141241\n"
                              " 07 80 10 27 10 27 00 00\n"
                              "\n"
                              "003:005:000:STREAM             1436110030.143241\n"
                              " 01\n"
                              "\n"
                              "003:005:001:STREAM             1436110030.145241\n"
                              " 07 81 10 27 10 27 00 01\n";

TEST(UsbhidDump, IsALogOfItsInterfaces)
{
    auto const log = parsed_dump(kDump, "dump.txt");
    ASSERT_TRUE(log) << log.error().message;
    ASSERT_EQ(log->devices.size(), 2u);
    EXPECT_EQ(log->devices[0].interface_number, 1);
    EXPECT_EQ(log->devices[0].report_descriptor,
              bytes("05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 c0 c0"));
    EXPECT_EQ(log->devices[1].interface_number, 0);
    EXPECT_TRUE(log->devices[1].report_descriptor.empty());
    ASSERT_EQ(log->records.size(), 3u);
    EXPECT_EQ(log->records[0].time, timestamp_ns(0));
    EXPECT_EQ(log->records[2].time, timestamp_ns(4'000'000));
    EXPECT_EQ(log->records[1].device, 1u);
    auto const last = log->report(log->records[2]);
    EXPECT_EQ(std::vector(last.begin(), last.end()), bytes("07 81 10 27 10 27 00 01"));
    EXPECT_EQ(log->warning_count, 0u);
}

TEST(UsbhidDump, SkipsWhatIsNoBlock)
{
    auto const log = parsed_dump("001:002:000:STREAM 1.000001\n 01 zz\n\n"
                                 "001:002:000:STREAM 1.000002\n\n"
                                 "001:002:000:STREAM 1.000003\n 01\n"
                                 "001:002:000:NOISE  1.000004\n",
                                 "dump.txt");
    ASSERT_TRUE(log) << log.error().message;
    EXPECT_EQ(log->warning_count, 3u); // The last block runs into a line that is no bytes.
    EXPECT_TRUE(log->records.empty());
}

TEST(UsbhidDump, NeedsABlock)
{
    auto const log = parsed_dump("R: 1 c0\n", "dump.txt");
    ASSERT_FALSE(log);
    EXPECT_EQ(log.error().fault, Fault::User);
}

constexpr char const* kLibinput = "# libinput record\n"
                                  "version: 1\n"
                                  "ndevices: 1\n"
                                  "libinput:\n"
                                  "  version: \"1.22.1\"\n"
                                  "devices:\n"
                                  "- node: /dev/input/event5\n"
                                  "  evdev:\n"
                                  "    # Name: Wacom Pen\n"
                                  "    name: \"Wacom Pen\"\n"
                                  "    id: [3, 1386, 890, 273]\n"
                                  "  hid: [\n"
                                  "    0x05, 0x0d, 0x09, 0x02\n"
                                  "  ]\n"
                                  "  udev:\n"
                                  "    properties:\n"
                                  "    - ID_INPUT=1\n"
                                  "  events:\n"
                                  "  - hid:\n"
                                  "      time: [  0,      0]\n"
                                  "      hidraw3: [\n"
                                  "        0x02, 0x80\n"
                                  "      ]\n"
                                  "  - evdev:\n"
                                  "    - [  0,      0,   3,   0,   12] # EV_ABS / ABS_X\n"
                                  "  - hid:\n"
                                  "      time: [  1,    500]\n"
                                  "      hidraw3: [\n"
                                  "        0x02, 0xff\n"
                                  "      ]\n";

TEST(LibinputRecord, GivesItsRawReports)
{
    auto const log = parsed_record(kLibinput, "record.yml");
    ASSERT_TRUE(log) << log.error().message;
    ASSERT_EQ(log->devices.size(), 1u);
    EXPECT_EQ(log->devices[0].name, "Wacom Pen");
    EXPECT_EQ(log->devices[0].vendor_id, 0x056a);
    EXPECT_EQ(log->devices[0].product_id, 0x037a);
    EXPECT_EQ(log->devices[0].report_descriptor, bytes("05 0d 09 02"));
    ASSERT_EQ(log->records.size(), 2u);
    EXPECT_EQ(log->records[1].time, timestamp_ns(1'000'500'000));
    auto const last = log->report(log->records[1]);
    EXPECT_EQ(std::vector(last.begin(), last.end()), bytes("02 ff"));
}

TEST(LibinputRecord, SaysWhatIsWrong)
{
    EXPECT_NE(parsed_record("devices: [\n", "record.yml").error().message.find("record.yml:"),
              std::string::npos);
    EXPECT_NE(parsed_record("ndevices: 0\n", "record.yml").error().message.find("--with-hidraw"),
              std::string::npos);
    EXPECT_FALSE(parsed_record("- a\n- b\n", "record.yml"));
    EXPECT_FALSE(
        parsed_record("devices:\n- events:\n  - hid: {time: [x], hidraw0: [1]}\n", "record.yml"));
}

TEST(GuessLogFormat, TellsByTheFirstLines)
{
    EXPECT_EQ(guess_log_format(kDump), LogFormat::UsbhidDump);
    EXPECT_EQ(guess_log_format(kLibinput), LogFormat::LibinputRecord);
    EXPECT_EQ(guess_log_format("R: 1 c0\nE: 0.1 1 01\n"), LogFormat::TractusLog);
    EXPECT_EQ(guess_log_format(""), LogFormat::TractusLog);
}

} // namespace
} // namespace tractus::drivers
