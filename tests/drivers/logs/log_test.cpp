#include "drivers/logs/log.h"

#include "drivers/logs/log_source.h"
#include "drivers/logs/log_writer.h"
#include "tests/drivers/devices.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace tractus::drivers {
namespace {

Log parsed(std::string const& text)
{
    auto log = parse_log(text, "pen.hid");
    EXPECT_TRUE(log) << log.error().message;
    return log ? *log : Log();
}

std::string error_of(std::string const& text)
{
    auto const log = parse_log(text, "pen.hid");
    EXPECT_FALSE(log);
    return log ? "" : log.error().message;
}

std::vector<std::byte> report(Log const& log, std::size_t index)
{
    auto const view = log.report(log.records.at(index));
    return { view.begin(), view.end() };
}

constexpr char const* kOnePen = "# a comment\n"
                                "R: 3 05 0d c0\n"
                                "N: Wacom CTL-472\n"
                                "P: usb-0000:00:14.0-1/input0\n"
                                "I: 3 56a 037A\n"
                                "E: 000000.000000 2 02 80\n"
                                "E: 000001.007978 2 02 81\n";

TEST(LogReader, ReadsARecordingOfHidRecorder)
{
    auto const log = parsed(kOnePen);
    ASSERT_EQ(log.devices.size(), 1u);
    auto const& device = log.devices[0];
    EXPECT_EQ(device.name, "Wacom CTL-472");
    EXPECT_EQ(device.physical_path, "usb-0000:00:14.0-1/input0");
    EXPECT_EQ(device.location, "pen.hid:device 0");
    EXPECT_EQ(device.bus, 3);
    EXPECT_EQ(device.vendor_id, 0x056a);
    EXPECT_EQ(device.product_id, 0x037a);
    EXPECT_EQ(device.report_descriptor, bytes("05 0d c0"));
    ASSERT_EQ(log.records.size(), 2u);
    EXPECT_EQ(log.records[1].time, timestamp_ns(1'007'978'000));
    EXPECT_EQ(report(log, 1), bytes("02 81"));
    EXPECT_EQ(log.warning_count, 0u);
}

TEST(LogReader, ReadsTimesWithAnyNumberOfDigits)
{
    auto const log
        = parsed("R: 1 c0\nE: 0.007978 1 01\nE: 0.1234567899 1 01\nE: 3 1 01\nE: 12.5 1 01\n");
    ASSERT_EQ(log.records.size(), 4u);
    EXPECT_EQ(log.records[0].time, timestamp_ns(7'978'000));
    EXPECT_EQ(log.records[1].time, timestamp_ns(123'456'789));
    EXPECT_EQ(log.records[2].time, timestamp_ns(3'000'000'000));
    EXPECT_EQ(log.records[3].time, timestamp_ns(12'500'000'000));
}

TEST(LogReader, TellsDevicesApart)
{
    auto const log = parsed("D:0\nR: 1 c0\nN: pen\nD: 4\nR: 1 a0\nN: pad\nD: 0\nE: 0.1 1 "
                            "01\nD:4\nE: 0.2 1 02\nE: 0.3 1 03\n");
    ASSERT_EQ(log.devices.size(), 2u);
    EXPECT_EQ(log.devices[1].name, "pad");
    EXPECT_EQ(log.devices[1].location, "pen.hid:device 4");
    ASSERT_EQ(log.records.size(), 3u);
    EXPECT_EQ(log.records[0].device, 0);
    EXPECT_EQ(log.records[1].device, 1);
    EXPECT_EQ(log.records[2].device, 1);
}

TEST(LogReader, SkipsWhatItDoesNotKnow)
{
    auto const log = parsed("\xEF\xBB\xBFR: 1 c0\r\n\r\nB: 0.5 1 01\r\nX: ?\r\n - the second of "
                            "two lines\r\nE: 0.1 1 01\r\n");
    EXPECT_EQ(log.records.size(), 1u);
    EXPECT_EQ(log.warning_count, 0u);
}

TEST(LogReader, WarnsOfReportsThatAreNotWhole)
{
    auto const log = parsed("R: 1 c0\n"
                            "E: 0.1 2 01\n"
                            "E: 0.2 1 01 02\n"
                            "E: 0.3 1 0g\n"
                            "E: 0.4 1 01E: 0.5 1 02\n"
                            "E: soon 1 01\n"
                            "E: 0.6 0\n"
                            "E: 0.7 1 01\n");
    EXPECT_EQ(log.records.size(), 1u);
    ASSERT_EQ(log.warnings.size(), 6u);
    EXPECT_EQ(log.warnings[0].line, 2u);
    EXPECT_EQ(log.warnings[0].message, "a report of 1 bytes that announces 2: skipped");
    EXPECT_EQ(log.warnings[1].message, "a report of 2 bytes that announces 1: skipped");
    EXPECT_EQ(log.warnings[2].message, "not a report (\"E: <seconds> <length> <bytes>\"): skipped");
    EXPECT_EQ(log.warnings[5].message, "a report of 0 bytes, which is not in 1 to 512: skipped");
    EXPECT_EQ(
        summarize_warnings(log),
        "pen.hid: 6 odd lines, the first is line 2: a report of 1 bytes that announces 2: skipped");
}

TEST(LogReader, CountsMoreWarningsThanItKeeps)
{
    std::string text = "R: 1 c0\n";
    for (int i = 0; i < 1000; ++i)
        text += "E: 0.1 2 01\n";
    auto const log = parsed(text);
    EXPECT_EQ(log.warning_count, 1000u);
    EXPECT_EQ(log.warnings.size(), kMaxLogWarnings);
}

TEST(LogReader, LeavesOutReportsThatNoSourceSends)
{
    std::string text = "R: 1 c0\nE: 0.1 513";
    for (int i = 0; i < 513; ++i)
        text += " 00";
    auto const log = parsed(text + "\n");
    EXPECT_TRUE(log.records.empty());
    EXPECT_EQ(log.warning_count, 1u);
}

TEST(LogReader, DropsALastLineThatIsCutOff)
{
    std::string const whole = kOnePen;
    for (std::size_t cut = 1; cut < std::string("E: 000001.007978 2 02 81\n").size() - 3; ++cut) {
        auto const log = parsed(whole.substr(0, whole.size() - 1 - cut));
        EXPECT_EQ(log.records.size(), 1u);
        ASSERT_EQ(log.warnings.size(), 1u) << "cut by " << cut;
        EXPECT_EQ(log.warnings[0].message, "the last line is cut off: a report is dropped");
        EXPECT_EQ(log.warnings[0].line, 7u);
    }
    auto const whole_without_break = parsed(whole.substr(0, whole.size() - 1));
    EXPECT_EQ(whole_without_break.records.size(), 2u);
    EXPECT_EQ(whole_without_break.warning_count, 0u);
}

TEST(LogReader, ReadsToolChangesInTheirPlace)
{
    auto const log = parsed("R: 1 c0\nE: 0.1 1 01\nT: 1.250000 draw descendants of 7\nE: 1.5 1 "
                            "01\nT: 2 select\nT: later draw\nT: 3 dra");
    ASSERT_EQ(log.tools.size(), 2u);
    EXPECT_EQ(log.tools[0].time, timestamp_ns(1'250'000'000));
    EXPECT_EQ(log.tools[0].tool, "draw");
    EXPECT_EQ(log.tools[0].arguments, "descendants of 7");
    EXPECT_EQ(log.tools[0].position, 1u);
    EXPECT_EQ(log.tools[1].arguments, "");
    EXPECT_EQ(log.tools[1].position, 2u);
    EXPECT_EQ(log.warning_count, 2u);
}

TEST(LogReader, KeepsTheRigAsItIs)
{
    auto const log = parsed("R: 1 c0\nC: [height]\nC:   offset_mm = 1.5\nC:\nC: # end\n");
    EXPECT_EQ(log.rig_text, "[height]\n  offset_mm = 1.5\n\n# end\n");
}

TEST(LogReader, KeepsTheFirstOfTwoDescriptors)
{
    auto const log = parsed("R: 1 c0\nR: 1 c0\nR: 1 a0\nE: 0.1 1 01\n");
    EXPECT_EQ(log.devices[0].report_descriptor, bytes("c0"));
    EXPECT_EQ(log.warning_count, 1u);
}

TEST(LogReader, RefusesWhatIsNoLog)
{
    EXPECT_EQ(error_of("to whom it may concern\n"),
              "pen.hid is not a log: none of its 1 lines is a report descriptor (\"R: <length> "
              "<bytes>\")");
    EXPECT_EQ(error_of(""),
              "pen.hid is not a log: none of its 0 lines is a report descriptor (\"R: <length> "
              "<bytes>\")");
}

// The second line states a size whose threefold overflows 64 bits to 2. This is the number of
// characters that follow, so a check by multiplication would accept the size.
TEST(LogReader, SkipsAReportWhoseSizeWouldWrapAround)
{
    auto const log = parsed("R: 1 c0\n"
                            "E: 9.0 6148914691236517206 x\n"
                            "E: 9.1 1 01\n");
    EXPECT_EQ(log.records.size(), 1u);
    ASSERT_EQ(log.warnings.size(), 1u);
    EXPECT_EQ(log.warnings[0].line, 2u);
}

TEST(LogReader, RefusesALineThatIsNoLogs)
{
    auto const line = std::string(std::size_t { 1 } << 20, 'x');
    EXPECT_EQ(error_of("R: 1 c0\n" + line + "y\n"),
              "pen.hid:2: a line of more than 1048576 bytes: this is no log");
    EXPECT_EQ(parsed("R: 1 c0\n" + line + "\nE: 0.1 1 01\n").records.size(), 1u);
    // A device file is refused because it could be endless.
    auto const zeros = read_log("/dev/zero");
    ASSERT_FALSE(zeros);
    EXPECT_EQ(zeros.error().message, "cannot read /dev/zero: it is a device");
}

TEST(LogReader, NamesTextInUtf16)
{
    std::string const utf16("\xff\xfeR\0:\0", 6);
    EXPECT_EQ(error_of(utf16), "pen.hid is text in UTF-16 or UTF-32: save it again as UTF-8");
    EXPECT_EQ(error_of(std::string("R\0:\0 \0", 6)),
              "pen.hid is text in UTF-16 or UTF-32: save it again as UTF-8");
}

// Lines must be read correctly wherever the file is divided into pieces.
TEST(LogReader, ReadsALogOfManyPieces)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_log_pieces_" + std::to_string(::getpid()));
    std::string text = "R: 1 c0\n";
    for (int i = 0; i < 20'000; ++i)
        text += "E: " + std::to_string(i) + ".5 3 01 02 03\n";
    std::ofstream(path) << text;
    auto const log = read_log(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(log) << log.error().message;
    EXPECT_EQ(log->records.size(), 20'000u);
    EXPECT_EQ(log->records, parsed(text).records);
    EXPECT_EQ(log->warning_count, 0u);
}

// Fixture with a log, as text and in a file, that is too large for all of its reports to stay in
// memory.
class LargeLog : public testing::Test {
protected:
    LargeLog()
    {
        text_ = "R: 1 c0\nN: pen\nD: 3\nR: 1 c0\nN: knob\n";
        for (int i = 0; i < 150'000; ++i) {
            text_ += "D: " + std::to_string(i % 1000 < 500 ? 0 : 3) + "\n";
            text_ += "E: " + std::to_string(i) + ".5 1 " + (i % 2 ? "01\n" : "a0\n");
            if (i % 10'000 == 0)
                text_ += "T: " + std::to_string(i) + ".5 draw trunk\nG: " + std::to_string(i)
                    + ".6\nE: 0.1 2 01\n";
        }
        text_ += "E: 150000.5 3 01"; // The report is truncated.
        std::ofstream(path_) << text_;
    }
    ~LargeLog() override { std::filesystem::remove(path_); }

    std::filesystem::path path_ = std::filesystem::temp_directory_path()
        / ("tractus_large_log_" + std::to_string(::getpid()));
    std::string text_;
};

TEST_F(LargeLog, IsReadAsIfItWereInMemory)
{
    auto const whole = parsed(text_);
    auto const log = read_log(path_).value();
    EXPECT_LT(log.records.size() * sizeof(LogRecord) + log.bytes.size(), kMaxLogBytes + 1000);
    EXPECT_EQ(log.record_count(), whole.records.size());
    EXPECT_EQ(log.begin(), whole.begin());
    EXPECT_EQ(log.end(), whole.end());
    EXPECT_EQ(log.warning_count, whole.warning_count);
    EXPECT_EQ(log.warnings.back().line, whole.warnings.back().line);
    ASSERT_EQ(log.tools.size(), whole.tools.size());
    for (std::size_t i = 0; i < log.tools.size(); ++i)
        EXPECT_EQ(log.tools[i].position, whole.tools[i].position);
    LogCursor cursor(log);
    for (auto const& record : whole.records) {
        auto const* const report = cursor.next().value();
        ASSERT_TRUE(report);
        ASSERT_EQ(report->time, record.time);
        ASSERT_EQ(report->device, record.device);
        ASSERT_TRUE(std::ranges::equal(report->bytes, whole.report(record)));
    }
    EXPECT_EQ(cursor.next().value(), nullptr);
    EXPECT_EQ(cursor.position(), whole.records.size());
}

TEST_F(LargeLog, ThatHasBeenCutMeanwhileEndsInAnError)
{
    auto const log = read_log(path_).value();
    std::filesystem::resize_file(path_, text_.size() / 2);
    LogCursor cursor(log);
    auto report = cursor.next();
    while (report && *report)
        report = cursor.next();
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().message,
              path_.string() + " has changed while it was read: read it again");
}

TEST_F(LargeLog, IsTheOneThatWasThereThoughAnotherTakesItsName)
{
    auto const log = read_log(path_).value();
    std::filesystem::remove(path_);
    LogCursor cursor(log);
    while (cursor.next().value()) { }
    EXPECT_EQ(cursor.position(), log.record_count());
}

TEST(LogReader, RefusesWhatAPipeHasNoEndOf)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_log_pipe_" + std::to_string(::getpid()));
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::signal(SIGPIPE, SIG_IGN);
    std::thread writer([&] {
        std::ofstream out(path);
        out << "R: 1 c0\n";
        for (std::size_t i = 0; i <= kMaxPipedLogBytes / sizeof(LogRecord) && out; ++i)
            out << "E: 0.5 1 01\n";
    });
    auto const log = read_log(path);
    writer.join();
    std::filesystem::remove(path);
    ASSERT_FALSE(log);
    EXPECT_NE(log.error().message.find("save it in a file first"), std::string::npos);
}

TEST(LogReader, RefusesDescriptionsWithoutEnd)
{
    std::string text = "R: 1 c0\n";
    while (text.size() < (std::size_t { 20 } << 20))
        text += "C: a = 1\n";
    auto const message = error_of(text);
    EXPECT_NE(message.find("this is no log"), std::string::npos) << message;
}

TEST(LogReader, RefusesADescriptorOfTheWrongLength)
{
    EXPECT_EQ(error_of("# pen\nR: 4 05 0d c0\n"),
              "pen.hid:2: a report descriptor of 3 bytes that announces 4");
    EXPECT_EQ(error_of("R: 18446744073709551615 05\n"),
              "pen.hid:1: a report descriptor of 1 bytes that announces 18446744073709551615");
    EXPECT_EQ(error_of("R: many\n"),
              "pen.hid:1: not a report descriptor (\"R: <length> <bytes>\")");
}

TEST(LogReader, RefusesReportsWithoutADescriptor)
{
    EXPECT_EQ(error_of("R: 1 c0\nD: 7\nN: pad\nE: 0.1 1 01\n"),
              "pen.hid:4: a report of device 7, which has no report descriptor (R line) before it");
}

TEST(LogReader, NamesAFileThatIsNotThere)
{
    auto const log = read_log("/nowhere/pen.hid");
    ASSERT_FALSE(log);
    EXPECT_EQ(log.error().fault, Fault::User);
    EXPECT_EQ(log.error().message, "cannot open /nowhere/pen.hid: No such file or directory");
}

TEST(LogReader, BoundsTheNumberOfDevices)
{
    std::string text = "R: 1 c0\n";
    for (int i = 1; i < 5000; ++i)
        text += "D: " + std::to_string(i) + "\nN: pen\n";
    EXPECT_LE(parsed(text).devices.size(), 1024u);
}

TEST(LogWriter, WritesWhatHidReplayReads)
{
    std::ostringstream out;
    LogWriter writer(
        out, { .devices = { simple_height_sensor() }, .start = timestamp_ns(5'000'000'000) });
    writer.write_report(0, timestamp_ns(5'007'978'900), bytes("01 34 02"));
    ASSERT_TRUE(writer.flush());
    EXPECT_EQ(out.str(),
              "R: 22 05 01 09 08 a1 01 85 01 09 36 15 00 26 ff 0f 75 10 95 01 81 02 c0\n"
              "N: Height Sensor\n"
              "P: \n"
              "I: 3 1209 0001\n"
              "E: 000000.007978 3 01 34 02\n");
}

TEST(LogWriter, WritesWhatTheReaderReads)
{
    std::ostringstream out;
    LogWriter writer(
        out, { .devices = { simple_pen(), simple_height_sensor() }, .rig_text = "a = 1\n\nb = 2" });
    writer.write_report(0, timestamp_ns(1'000), bytes("02 20"));
    writer.write_report(1, timestamp_ns(2'000), bytes("01 ff 0f"));
    writer.write_tool(timestamp_ns(3'000), "draw", "descendants");
    writer.write_report(1, timestamp_ns(4'000), bytes("01 00 00"));
    ASSERT_TRUE(writer.flush());

    auto const log = parsed(out.str());
    ASSERT_EQ(log.devices.size(), 2u);
    EXPECT_EQ(log.devices[0].name, "Simple Pen");
    EXPECT_EQ(log.devices[0].physical_path, simple_pen().physical_path);
    EXPECT_EQ(log.devices[1].report_descriptor, simple_height_sensor().report_descriptor);
    EXPECT_EQ(log.rig_text, "a = 1\n\nb = 2\n");
    ASSERT_EQ(log.records.size(), 3u);
    EXPECT_EQ(log.records[1].device, 1);
    EXPECT_EQ(log.records[2].time, timestamp_ns(4'000));
    EXPECT_EQ(report(log, 1), bytes("01 ff 0f"));
    ASSERT_EQ(log.tools.size(), 1u);
    EXPECT_EQ(log.tools[0].arguments, "descendants");
    EXPECT_EQ(log.tools[0].position, 2u);
    EXPECT_EQ(log.warning_count, 0u);
}

TEST(LogWriter, KeepsWhatADecoderIsChosenBy)
{
    auto info = simple_pen();
    info.physical_path = "usb-0000:00:14.0-2/input1";
    info.manufacturer = "Maker \\ Sons";
    info.serial_number = " 8JQ\n01 ";
    info.size_mm = Vec2(203, 127);
    info.strings = { { 200, std::string("\x01\0\xc3\xa9", 4) }, { 201, "HUION_T153_130524" } };
    std::ostringstream out;
    LogWriter writer(out, { .devices = { info, simple_pen() } });
    auto const log = parsed(out.str());
    ASSERT_EQ(log.devices.size(), 2u);
    EXPECT_EQ(log.devices[0].manufacturer, info.manufacturer);
    EXPECT_EQ(log.devices[0].serial_number, info.serial_number);
    EXPECT_EQ(log.devices[0].strings, info.strings);
    EXPECT_EQ(log.devices[0].size_mm, info.size_mm);
    EXPECT_FALSE(log.devices[1].size_mm);
    EXPECT_EQ(log.devices[0].interface_number, 1);
    EXPECT_TRUE(log.devices[1].strings.empty());
    EXPECT_EQ(log.warning_count, 0u);
    EXPECT_NE(out.str().find("\nS: 201 HUION_T153_130524\n"), std::string::npos);
}

TEST(ParseLog, SkipsWhatIsNoTabletsSize)
{
    for (auto const* const size : { "", "203", "203 x", "0 127", "203 999999999999", "-5 127" }) {
        auto const log
            = parsed(std::string("R: 2 05 0d\nA: ") + size + "\nE: 000000.000000 1 07\n");
        ASSERT_EQ(log.devices.size(), 1u);
        EXPECT_FALSE(log.devices[0].size_mm) << size;
        EXPECT_EQ(log.warning_count, 1u) << size;
        EXPECT_EQ(log.record_count(), 1u);
    }
}

TEST(LogWriter, KeepsThatADeviceWentAway)
{
    std::ostringstream out;
    LogWriter writer(out, { .devices = { simple_pen(), simple_height_sensor() } });
    writer.write_report(1, timestamp_ns(1'000), bytes("01 00 00"));
    writer.write_report(0, timestamp_ns(2'000), {});
    EXPECT_NE(out.str().find("D: 0\nG: 000000.000002\n"), std::string::npos) << out.str();
    auto const log = parsed(out.str());
    ASSERT_EQ(log.records.size(), 2u);
    EXPECT_EQ(log.records[1].device, 0);
    EXPECT_EQ(log.records[1].size, 0u);
    EXPECT_EQ(log.records[1].time, timestamp_ns(2'000));
    EXPECT_EQ(log.warning_count, 0u);
}

TEST(LogReader, WarnsOfStringsThatAreNone)
{
    auto const log = parsed("R: 1 c0\nS: 256 text\nS: text\nS: 3 a \\x4 b\nS: 4 cut");
    EXPECT_EQ(log.devices[0].strings, (std::map<int, std::string> { { 3, "a \\x4 b" } }));
    EXPECT_EQ(log.warning_count, 3u);
}

TEST(LogWriter, KeepsANameOnItsLine)
{
    auto info = simple_pen();
    info.name = "Pen\nE: 0.0 1 00";
    std::ostringstream out;
    LogWriter writer(out, { .devices = { info } });
    EXPECT_EQ(parsed(out.str()).devices[0].name, "Pen E: 0.0 1 00");
}

TEST(LogWriter, TellsThatTheDiskIsFull)
{
    std::ofstream full("/dev/full");
    LogWriter writer(full, { .devices = { simple_pen() } });
    auto const result = writer.flush();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "cannot write the log: No space left on device");
}

TEST(LogSource, ReplaysItsDevice)
{
    auto const log
        = parsed("D: 0\nR: 1 c0\nN: pen\nD: 1\nR: 1 a0\nE: 0.1 1 01\nD: 0\nE: 0.2 2 02 03\n");
    LogSource source(log, 0);
    EXPECT_EQ(source.info().name, "pen");
    auto const first = source.read(Duration(0));
    ASSERT_TRUE(first && *first);
    EXPECT_EQ((*first)->received, timestamp_ns(200'000'000));
    EXPECT_EQ((*first)->size, 2u);
    EXPECT_EQ((*first)->bytes()[1], std::byte { 3 });
    EXPECT_EQ(source.read(Duration(0)).value(), std::nullopt);
}

} // namespace
} // namespace tractus::drivers
