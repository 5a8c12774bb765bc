// Tests the driver of serial ports with a simulated board behind a pseudo-terminal: the same system
// calls as with a real board.

#include "drivers/sensors/serial_line.h"

#include "drivers/device_kind.h"
#include "drivers/device_list.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "drivers/reconnecting_source.h"
#include "tests/drivers/heights.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// A board whose output arrives at the node.
class SimulatedBoard {
public:
    SimulatedBoard()
        : file_(::posix_openpt(O_RDWR | O_NOCTTY))
    {
        ::grantpt(file_);
        ::unlockpt(file_);
        char name[64] = {};
        if (::ptsname_r(file_, name, sizeof(name)) == 0)
            node_ = name;
    }
    ~SimulatedBoard() { unplug(); }
    SimulatedBoard(SimulatedBoard const&) = delete;
    SimulatedBoard& operator=(SimulatedBoard const&) = delete;

    std::string const& node() const { return node_; }
    void print(std::string_view text) const
    {
        ASSERT_EQ(::write(file_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    void unplug()
    {
        if (file_ >= 0)
            ::close(file_);
        file_ = -1;
    }

private:
    int file_;
    std::string node_;
};

std::string text_of(RawReport const& report)
{
    return { reinterpret_cast<char const*>(report.storage.data()), report.size };
}

// Returns all lines that have arrived.
std::vector<std::string> lines_of(ReportSource& source)
{
    std::vector<std::string> lines;
    for (;;) {
        auto const report = source.read(0ms);
        if (!report || !*report)
            return lines;
        lines.push_back(text_of(**report));
    }
}

using Lines = std::vector<std::string>;

std::unique_ptr<ReportSource> open_board(SimulatedBoard const& board, std::string settings = "")
{
    auto info = describe_serial_line(board.node()).value();
    info.settings = std::move(settings);
    auto source = open_serial_line(std::move(info));
    EXPECT_TRUE(source) << source.error().message;
    return source ? *std::move(source) : nullptr;
}

TEST(SerialLine, GivesWholeLinesHoweverTheyArrive)
{
    SimulatedBoard const board;
    auto const source = open_board(board);
    ASSERT_TRUE(source);
    EXPECT_EQ(lines_of(*source), Lines {});
    board.print("98\n512\r\n\n51");
    EXPECT_EQ(lines_of(*source), Lines { "512" }) << "the first may have begun before";
    board.print("3\n514\n");
    EXPECT_EQ(lines_of(*source), (Lines { "513", "514" }));
    board.print(std::string(600, 'x') + "\n515\n");
    EXPECT_EQ(lines_of(*source), Lines { "515" });
    EXPECT_EQ(source->oversized_count(), 1u);
}

TEST(SerialLine, WaitsForTheNextLine)
{
    SimulatedBoard const board;
    auto const source = open_board(board);
    ASSERT_TRUE(source);
    board.print("0\n7\n");
    auto const report = source->read(60s); // The read returns at once.
    ASSERT_TRUE(report && *report);
    EXPECT_EQ(text_of(**report), "7");
}

TEST(SerialLine, TellsThatTheBoardIsGone)
{
    SimulatedBoard board;
    auto const source = open_board(board);
    ASSERT_TRUE(source);
    board.unplug();
    auto const report = source->read(60s);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::Device);
    EXPECT_NE(report.error().message.find("is gone"), std::string::npos);
}

TEST(SerialLine, SaysWhatIsWrongAtOpening)
{
    SimulatedBoard const board;
    auto info = describe_serial_line(board.node()).value();
    for (std::string const settings : { "12345", "max=0", "fast", "9600,,", "max=1023;9600" }) {
        info.settings = settings;
        auto const source = open_serial_line(info);
        ASSERT_FALSE(source) << settings;
        EXPECT_EQ(source.error().fault, Fault::User);
    }
    EXPECT_FALSE(describe_serial_line("/dev/pts/no-such-line"));
    info.settings.clear();
    info.location = "/dev/null";
    EXPECT_EQ(open_serial_line(info).error().message, "/dev/null is no serial line");
}

TEST(SerialLine, IsReadOnlyWhereItIsNamed)
{
    SimulatedBoard const board;
    auto const found = find_device(board.node() + "@9600,max=1023");
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(describe_device(*found).kind, DeviceKind::Other);
    EXPECT_NE(describe_device(*found).text.find("if it is named"), std::string::npos);
    auto const source = open_device(*found);
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(describe_device((*source)->info()).kind, DeviceKind::Height);
    EXPECT_EQ(make_height_decoder((*source)->info()).value()->full_scale(), 1023);
}

TEST(SerialLine, ReplaysFromALogAsItWasRead)
{
    SimulatedBoard const board;
    auto const source = open_board(board, "9600,max=500.00");
    ASSERT_TRUE(source);
    board.print("\n23.75\nwhat\n24\n");
    std::ostringstream out;
    LogWriter writer(out, { .devices = { source->info() } });
    std::vector<HeightSample> live;
    auto decoder = make_height_decoder(source->info()).value();
    for (auto report = source->read(0ms).value(); report; report = source->read(0ms).value()) {
        report->received = timestamp_ns(1000 * report->received.time_since_epoch().count() / 1000);
        writer.write_report(0, report->received, report->bytes());
        std::ignore = decoder->decode(*report, live);
    }
    ASSERT_TRUE(writer.flush());
    auto const log = parse_log(out.str(), "log").value();
    EXPECT_EQ(describe_device(log.devices.at(0)).kind, DeviceKind::Height);
    auto again = make_height_decoder(log.devices[0]).value();
    std::vector<HeightSample> replayed;
    for (auto const& record : log.records)
        std::ignore = again->decode(record.time, log.report(record), replayed);
    ASSERT_EQ(live.size(), 2u);
    ASSERT_EQ(replayed.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(replayed[i].counts, live[i].counts);
    EXPECT_EQ(live[0].counts, 2375);
    EXPECT_EQ(log.records.size(), 3u) << "what could not be decoded is in the log, too";
}

// The board is unplugged, and returns at another node. A symbolic link, as udev makes it, points to
// the board's present node.
TEST(SerialLine, GoesOnWhenTheBoardIsBack)
{
    auto const link
        = std::filesystem::temp_directory_path() / ("tractus_serial_" + std::to_string(::getpid()));
    auto const point_to = [&](SimulatedBoard const& board) {
        std::filesystem::remove(link);
        std::filesystem::create_symlink(board.node(), link);
    };
    Timestamp now {};
    Reconnection reconnection { .list = [] { return std::vector<DeviceInfo>(); },
                                .open = open_serial_line,
                                .now = [&] { return now; },
                                .slept = [] { return Duration(0); } };
    reconnection.retry_every = Duration(0);
    auto board = std::make_unique<SimulatedBoard>();
    point_to(*board);
    DeviceInfo const info { .name = "board", .location = "/dev/pts/../../" + link.string() };
    auto source = ReconnectingSource::open(info, reconnection).value();
    board->print("0\n1\n");
    EXPECT_EQ(text_of(source->read(0ms).value().value()), "1");
    board->unplug();
    EXPECT_EQ(source->read(1s).value().value().size, 0u) << "it went away";
    EXPECT_FALSE(source->is_connected());
    board = std::make_unique<SimulatedBoard>();
    point_to(*board);
    for (int i = 0; i < 10 && !source->is_connected(); ++i)
        EXPECT_FALSE(source->read(0ms).value());
    ASSERT_TRUE(source->is_connected());
    board->print("2\n3\n");
    EXPECT_EQ(text_of(source->read(0ms).value().value()), "3");
    std::filesystem::remove(link);
}

TEST(SerialLine, ListsWhatTheKernelHasOnUsb)
{
    namespace fs = std::filesystem;
    auto const root = fs::temp_directory_path() / ("tractus_tty_" + std::to_string(::getpid()));
    auto const usb = root / "devices/usb1/1-2";
    fs::create_directories(usb / "1-2:1.0");
    fs::create_directories(root / "tty/ttyACM0");
    fs::create_directories(root / "tty/ttyUSB3");
    fs::create_directories(root / "tty/ttyS0");
    fs::create_symlink(usb / "1-2:1.0", root / "tty/ttyACM0/device");
    std::ofstream(usb / "idVendor") << "2341\n";
    std::ofstream(usb / "idProduct") << "0043\n";
    std::ofstream(usb / "product") << "Arduino Uno\n";
    std::ofstream(usb / "serial") << "7583\n";
    auto const lines = list_serial_lines(root / "tty");
    fs::remove_all(root);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].location, "/dev/ttyACM0");
    EXPECT_EQ(lines[0].name, "Arduino Uno");
    EXPECT_EQ(lines[0].vendor_id, 0x2341);
    EXPECT_EQ(lines[0].serial_number, "7583");
    EXPECT_EQ(lines[1].location, "/dev/ttyUSB3");
    EXPECT_TRUE(list_serial_lines(root / "tty").empty());
}

} // namespace
} // namespace tractus::drivers
