#include "drivers/logs/foreign_log.h"

#include "drivers/logs/lent_descriptors.h"
#include "drivers/tablets/pen_decoders.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/decode_one.h"
#include "tests/drivers/devices.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

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
    EXPECT_EQ(log->warning_count, 3u); // The last block is followed by a line that is not bytes.
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

// A libinput recording without raw reports, of a touchpad and of a pen.
constexpr char const* kLibinputEvents
    = "version: 1\nndevices: 2\nlibinput:\n  version: \"1.22.1\"\ndevices:\n"
      "- node: /dev/input/event4\n"
      "  evdev:\n    name: \"Touchpad\"\n    id: [24, 1267, 12, 256]\n"
      "    codes:\n      1: [325, 330]\n      3: [0, 1]\n"
      "    absinfo:\n      0: [0, 3200, 0, 0, 31]\n      1: [0, 2000, 0, 0, 31]\n"
      "  events:\n  - evdev:\n    - [  0,  1, 3, 0, 5]\n    - [  0,  1, 0, 0, 0]\n"
      "- node: /dev/input/event5\n"
      "  evdev:\n    name: \"Surface Pen\"\n    id: [24, 1118, 890, 273]\n"
      "    codes:\n      0: [0]\n      1: [320, 321, 330, 331]\n      3: [0, 1, 24]\n"
      "    absinfo:\n      0: [0, 26000, 0, 0, 100]\n      1: [0, 17000, 0, 0, 100]\n"
      "      24: [0, 4095, 0, 0, 0]\n"
      "  hid: [\n    0x05, 0x0d\n  ]\n"
      "  events:\n"
      "  - evdev:\n"
      "    - [  0,    500,   1, 320,    1] # EV_KEY / BTN_TOOL_PEN\n"
      "    - [  0,    500,   3,   0, 1000] # EV_ABS / ABS_X\n"
      "    - [  0,    500,   3,   1, 7000] # EV_ABS / ABS_Y\n"
      "    - [  0,    500,   0,   0,    0] # SYN_REPORT\n"
      "  - libinput:\n    - {time: 0.0, type: TABLET_TOOL_PROXIMITY}\n"
      "  - evdev:\n"
      "    - [  0,   9500,   1, 330,    1]\n"
      "    - [  0,   9500,   3,  24, 2048]\n"
      "    - [  0,   9500,   3,   0, 1100]\n"
      "    - [  0,   9500,   0,   0,    0]\n";

TEST(LibinputRecord, GivesAPensEventsWhereItHasNoRawReports)
{
    auto const log = parsed_record(kLibinputEvents, "record.yml");
    ASSERT_TRUE(log) << log.error().message;
    ASSERT_EQ(log->devices.size(), 1u);
    EXPECT_EQ(log->devices[0].name, "Surface Pen");
    EXPECT_EQ(log->devices[0].bus, 0x18);
    auto pen = make_pen_decoder(log->devices[0]).value();
    EXPECT_NEAR(pen->traits().size_mm.x(), 260, 1e-6);
    EXPECT_NEAR(pen->traits().size_mm.y(), 170, 1e-6);
    ASSERT_EQ(log->records.size(), 2u);
    EXPECT_EQ(log->records[1].time, timestamp_ns(9'000'000));
    auto const hovering = decode_one(*pen, log->records[0].time, log->report(log->records[0]));
    ASSERT_TRUE(hovering && *hovering);
    EXPECT_FALSE((*hovering)->touching);
    auto const touching = decode_one(*pen, log->records[1].time, log->report(log->records[1]));
    ASSERT_TRUE(touching && *touching);
    EXPECT_TRUE((*touching)->touching);
    EXPECT_NEAR((*touching)->position_mm.x(), 11, 1e-6);
    EXPECT_NEAR((*touching)->position_mm.y(), 100, 1e-6);
    EXPECT_NEAR((*touching)->pressure.value(), 2048.0 / 4095, 1e-9);
}

TEST(LibinputRecord, BelievesRawReportsMoreThanEvents)
{
    std::string const raw = "  - hid:\n      time: [  0,    400]\n      hidraw3: [0x02, 0x80]\n";
    std::string text = kLibinputEvents;
    auto const last = parsed_record(text + raw, "record.yml").value();
    ASSERT_EQ(last.devices.size(), 1u);
    EXPECT_EQ(last.devices[0].report_descriptor, bytes("05 0d"));
    ASSERT_EQ(last.records.size(), 1u);
    EXPECT_EQ(last.records[0].device, 0u);
}

TEST(LibinputRecord, RefusesEventsThatAreNone)
{
    std::string const text = kLibinputEvents;
    for (std::string const event : { "[0, 1, 3, 0]", "[0, x, 3, 0, 1]", "[-1, 0, 3, 0, 1]" }) {
        auto const log = parsed_record(text + "    - " + event + "\n", "record.yml");
        ASSERT_FALSE(log) << event;
        EXPECT_NE(log.error().message.find("record.yml:"), std::string::npos);
    }
}

// An evemu recording with axes as version 1.2 writes them, and a comment after each event.
constexpr char const* kEvemu = "# EVEMU 1.2\n"
                               "# Input device name: \"Pen\"\n"
                               "N: Pen # 2\n"
                               "I: 0018 1b96 1000 0000\n"
                               "P: 00 00 00 00 00 00 00 00\n"
                               "B: 00 0b 00 00 00 00 00 00 00\n"
                               // Codes 0x140 and 0x14a are bit 0 of byte 40 and bit 2 of byte 41.
                               "B: 01 00 00 00 00 00 00 00 00\nB: 01 00 00 00 00 00 00 00 00\n"
                               "B: 01 00 00 00 00 00 00 00 00\nB: 01 00 00 00 00 00 00 00 00\n"
                               "B: 01 00 00 00 00 00 00 00 00\nB: 01 03 04 00 00 00 00 00 00\n"
                               "B: 03 03 00 00 01 00 00 00 00\n"
                               "A: 00 0 9600 0 0 50\n"
                               "A: 01 0 7200 0 0 50\n"
                               "A: 18 0 256 0 0\n"
                               "E: 1370598514.1 0001 0141 0001\n"
                               "E: 1370598514.1 0003 0000 9600\t# EV_ABS / ABS_X\n"
                               "E: 1370598514.1 0003 0001 -5\n"
                               "E: 1370598514.1 0000 0000 0000\n"
                               "E: 1370598514.2 0001 014a 0001\n"
                               "E: 1370598514.2 0000 0000 0000\n"
                               "E: 1370598514.3 what\n"
                               "E: 1370598514.4 0001 0141 0000\n"
                               "E: 1370598514.4 0000 0000 0000\n"
                               "E: 1370598514.5 0000 0000 0001\n";

TEST(Evemu, GivesTheReportsOfAPen)
{
    std::istringstream in(kEvemu);
    auto const log = parse_evemu(in, "pen.ev");
    ASSERT_TRUE(log) << log.error().message;
    ASSERT_EQ(log->devices.size(), 1u);
    EXPECT_EQ(log->devices[0].name, "Pen # 2");
    EXPECT_EQ(log->devices[0].product_id, 0x1000);
    EXPECT_EQ(log->warning_count, 1u);
    ASSERT_EQ(log->records.size(), 3u);
    EXPECT_EQ(log->records[1].time, timestamp_ns(100'000'000));
    auto pen = make_pen_decoder(log->devices[0]).value();
    EXPECT_TRUE(pen->traits().has_eraser);
    std::vector<PenSample> samples;
    for (auto const& record : log->records)
        ASSERT_TRUE(pen->decode(record.time, log->report(record), samples));
    ASSERT_EQ(samples.size(), 3u);
    EXPECT_TRUE(samples[0].in_range && samples[0].eraser && !samples[0].touching);
    EXPECT_NEAR(samples[0].position_mm.x(), 192, 1e-6);
    EXPECT_NEAR(samples[0].position_mm.y(), 144.1, 1e-6) << "5 counts beyond the far edge";
    EXPECT_TRUE(samples[1].touching && samples[1].eraser);
    EXPECT_FALSE(samples[2].in_range);
}

TEST(Evemu, NeedsAPen)
{
    for (std::string const text :
         { "# EVEMU 1.3\n", "# EVEMU 1.3\nN: Mouse\nI: 3 1 2 3\nB: 01 00\nE: 0.1 2 0 1\n",
           "# EVEMU 1.3\nB: 01 ff ff ff ff ff ff ff ff\nA: 00 0 1 0 0\nA: 01 0 1 0 0\n" }) {
        std::istringstream in(text);
        auto const log = parse_evemu(in, "mouse.ev");
        ASSERT_FALSE(log);
        EXPECT_EQ(log.error().fault, Fault::User);
        EXPECT_NE(log.error().message.find("is no pen"), std::string::npos);
    }
}

// A damaged recording must give a log or a one-sentence error.
TEST(ForeignLogs, SurviveDamage)
{
    std::mt19937 random(7);
    for (std::string const whole : { kDump, kLibinput, kLibinputEvents, kEvemu })
        for (int i = 0; i < 300; ++i) {
            auto text = whole;
            for (int changes = 0; changes < 4; ++changes)
                text[random() % text.size()] = static_cast<char>(random() % 256);
            text.resize(text.size() - random() % 40);
            for (auto* const parse : { parse_usbhid_dump, parse_libinput_record, parse_evemu }) {
                std::istringstream in(text);
                auto const log = parse(in, "damaged");
                if (!log)
                    EXPECT_FALSE(log.error().message.empty());
                else
                    for (auto const& record : log->records)
                        ASSERT_LT(record.device, log->devices.size());
            }
        }
}

TEST(UsbhidDump, PutsTheReportsOfDevicesInTheOrderOfTheirTimes)
{
    auto const log = parsed_dump("001:002:000:STREAM 1.000003\n 01\n\n"
                                 "001:002:000:STREAM 1.000001\n 02\n\n"
                                 "001:002:001:STREAM 1.000002\n 03\n\n",
                                 "dump.txt")
                         .value();
    std::string order;
    for (auto const& record : log.records)
        order += std::to_string(std::to_integer<int>(log.report(record)[0]));
    EXPECT_EQ(order, "312") << "a device's own reports stay in their order";
}

// Returns a log of two interfaces of one tablet: their descriptors, and pen reports of simple_pen()
// on one of them.
Log log_of_two_interfaces(std::string const& own, int own_interface, int describing_interface)
{
    Log log { .name = "dump.txt" };
    DeviceInfo sending { .interface_number = own_interface, .report_descriptor = bytes(own) };
    auto describing = simple_pen();
    describing.interface_number = describing_interface;
    sending.vendor_id = describing.vendor_id;
    sending.product_id = describing.product_id;
    sending.physical_path = "usb-1/input" + std::to_string(own_interface);
    describing.physical_path = "usb-1/input" + std::to_string(describing_interface);
    log.devices = { sending, describing };
    log.bytes = bytes("02 21 10 27 88 13 00 04 00 00");
    for (int i = 0; i < 3; ++i)
        log.records.push_back({ .time = timestamp_ns(i), .offset = 0, .size = 10, .device = 0 });
    return log;
}

constexpr char const* kKeyboard = "05 01 09 06 a1 01 85 05 09 01 15 00 25 01 75 08 95 01 81 02 c0";

TEST(LendDescriptors, DescribesReportsByAnotherInterfaceOfTheTablet)
{
    auto log = log_of_two_interfaces(kKeyboard, 1, 2);
    lend_descriptors(log);
    EXPECT_EQ(log.devices[0].report_descriptor, simple_pen().report_descriptor);
    EXPECT_EQ(log.devices[0].interface_number, 1);
    auto pen = make_pen_decoder(log.devices[0]).value();
    auto const sample = decode_one(*pen, Timestamp {}, log.report(log.records[0]));
    ASSERT_TRUE(sample && *sample);
    EXPECT_NEAR((*sample)->position_mm.x(), 100, 1e-6);
}

TEST(LendDescriptors, LeavesAloneWhatDescribesItselfOrIsOfAnotherDevice)
{
    auto const is_left = [](Log log) {
        auto const before = log.devices[0].report_descriptor;
        lend_descriptors(log);
        return log.devices[0].report_descriptor == before;
    };
    auto other = log_of_two_interfaces(kKeyboard, 1, 2);
    other.devices[1].physical_path = "usb-2/input2";
    EXPECT_TRUE(is_left(other));
    auto keys = log_of_two_interfaces(kKeyboard, 1, 2);
    keys.bytes.insert(keys.bytes.end(), { std::byte { 5 }, std::byte { 1 } });
    keys.records.push_back({ .time = {}, .offset = 10, .size = 2, .device = 0 });
    EXPECT_TRUE(is_left(keys)) << "it sends reports of its own, too";
    EXPECT_TRUE(
        is_left(log_of_two_interfaces("05 01 09 06 a1 01 15 00 25 01 75 08 95 01 81 02 c0", 1, 2)))
        << "without ids any byte may come first";
    auto unknown = log_of_two_interfaces(kKeyboard, 1, 2);
    unknown.bytes[0] = std::byte { 9 };
    EXPECT_TRUE(is_left(unknown));
}

TEST(ReadLog, TellsByTheContent)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_any_log_" + std::to_string(::getpid()));
    for (std::string const text : { kDump, kLibinput, kLibinputEvents, kEvemu }) {
        std::ofstream(path, std::ios::binary) << text;
        auto const log = read_log(path);
        ASSERT_TRUE(log) << log.error().message;
        EXPECT_GE(log->records.size(), 2u);
        std::filesystem::remove(path);
        ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
        std::thread writer([&] { std::ofstream(path, std::ios::binary) << text; });
        auto const piped = read_log(path);
        writer.join();
        std::filesystem::remove(path);
        ASSERT_TRUE(piped) << piped.error().message;
        EXPECT_EQ(piped->records, log->records);
        EXPECT_EQ(piped->bytes, log->bytes);
    }
}

TEST(GuessLogFormat, TellsByTheFirstLines)
{
    EXPECT_EQ(guess_log_format(kDump), LogFormat::UsbhidDump);
    EXPECT_EQ(guess_log_format(kLibinput), LogFormat::LibinputRecord);
    EXPECT_EQ(guess_log_format("R: 1 c0\nE: 0.1 1 01\n"), LogFormat::TractusLog);
    EXPECT_EQ(guess_log_format("# EVEMU 1.3\n# Input device\n"), LogFormat::Evemu);
    EXPECT_EQ(guess_log_format("N: Pen\nI: 0018 056a 5196 0100\n"), LogFormat::Evemu);
    EXPECT_EQ(guess_log_format("R: 1 c0\nN: Pen\nI: 18 056a 5196\n"), LogFormat::TractusLog);
    EXPECT_EQ(guess_log_format(std::string(5'000, '#') + "\n" + kDump), LogFormat::UsbhidDump);
    EXPECT_EQ(guess_log_format(""), std::nullopt);
    EXPECT_EQ(guess_log_format("S 3 0 1\n0 0 0 1 0\n"), std::nullopt) << "strokes in space";
}

} // namespace
} // namespace tractus::drivers
