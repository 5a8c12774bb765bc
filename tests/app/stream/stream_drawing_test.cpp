#include "app/stream/stream_drawing.h"

#include "app/methods/all_methods.h"
#include "app/stream/stream_lines.h"
#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "tests/app/flat_station.h"
#include "tests/app/stream/local_reader.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace tractus::stream {
namespace {

station::LogReplay small_replay(drivers::Log const& log)
{
    return station::LogReplay::create(log, { .methods = methods::all_methods() }).value();
}

drivers::Log small_log()
{
    return drivers::read_log(std::filesystem::path(TRACTUS_FIXTURES) / "small.tractus-log").value();
}

// Returns all lines of `what` that are streamed from a log.
std::string streamed(drivers::Log const& log, StreamOutput::What what)
{
    auto replay = small_replay(log);
    std::string text;
    auto const write = [&](std::string_view line) {
        text += line;
        return Result<void>();
    };
    auto output = StreamOutput::open(write, replay.station().volume_mm(), what).value();
    std::atomic<bool> const stop = false;
    auto const outcome = stream_log(replay, output, std::nullopt, stop);
    EXPECT_TRUE(outcome) << outcome.error().message;
    return text;
}

// The expected file small.jsonl was written by tests/fixtures/stream_small, which shares no code
// with the program.
TEST(StreamDrawing, GivesASmallLogToTheByte)
{
    EXPECT_EQ(streamed(small_log(), StreamOutput::What::All),
              file_bytes(std::filesystem::path(TRACTUS_FIXTURES) / "small.jsonl"));
}

TEST(StreamDrawing, GivesStrokesAlone)
{
    auto const text = streamed(small_log(), StreamOutput::What::Strokes);
    EXPECT_EQ(text.find("\"tip\""), std::string::npos);
    // The lines are the first line, two strokes and the last line.
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
}

TEST(StreamDrawing, EndsWhereNothingCanBeWritten)
{
    auto const log = small_log();
    auto replay = small_replay(log);
    int count = 0;
    auto const write = [&](std::string_view) -> Result<void> {
        if (++count > 3)
            return fail(Fault::User, "cannot write to standard output: it is closed");
        return {};
    };
    auto output = StreamOutput::open(write, {}, StreamOutput::What::All).value();
    std::atomic<bool> const stop = false;
    auto const outcome = stream_log(replay, output, std::nullopt, stop);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().message, "cannot write to standard output: it is closed");
}

class StreamSocket : public SocketPlace { };

// The pen draws two thousand strokes while one reader does not read and another disconnects. take()
// and serve() must return each time, and no stroke may be lost.
TEST_F(StreamSocket, NeverStopsTheDrawing)
{
    auto station = flat_station();
    auto output
        = StreamOutput::open_socket(path_, station.volume_mm(), StreamOutput::What::All).value();
    LocalReader const slow(path_);
    LocalReader gone(path_);
    output.serve({});
    for (int i = 0; i < 2000; ++i) {
        draw_across(station, 1000 * i);
        ASSERT_TRUE(output.take(station, scene::Scene()));
        output.serve({});
        if (i == 10)
            gone.leave();
    }
    EXPECT_EQ(station.counts().strokes, 2000u);
    ASSERT_TRUE(output.has_readers());
    ASSERT_TRUE(output.end());
    std::string text;
    for (std::string part = "-"; !part.empty();) {
        output.serve({});
        part = slow.read_now();
        text += part;
    }
    std::size_t strokes = 0;
    for (auto at = text.find("\"stroke\""); at != std::string::npos;
         at = text.find("\"stroke\"", at + 1))
        ++strokes;
    EXPECT_EQ(strokes, 2000u);
    EXPECT_NE(text.find("{\"type\":\"lost\",\"tips\":"), std::string::npos);
    EXPECT_EQ(text.substr(text.size() - end_line().size()), end_line());
}

// One reader reads everything, and another reads nothing. The first one must receive the end of the
// stream. The test's clock advances only when the program waits.
TEST_F(StreamSocket, EndsThoughAReaderNeverReads)
{
    std::ostringstream text;
    drivers::LogWriter writer(text, { .devices = { drivers::simple_pen() } });
    for (int i = 0; i < 20'000; ++i)
        writer.write_report(kPen, at_ms(5 * i), pen_report(50 + i % 100, 50, i % 200 < 150));
    ASSERT_TRUE(writer.flush());
    auto const log = drivers::parse_log(text.str(), "long").value();
    station::ReplayOptions options { .methods = methods::all_methods() };
    options.height = calib::parse_height_scenario("100").value();
    auto replay = station::LogReplay::create(log, options).value();
    auto output
        = StreamOutput::open_socket(path_, replay.station().volume_mm(), StreamOutput::What::All)
              .value();
    LocalReader const stuck(path_);
    LocalReader const other(path_);
    std::string read;
    Timestamp now {};
    play::Pace clock;
    clock.now = [&] { return now; };
    clock.wait = [&](Duration duration) {
        now += duration;
        read += other.read_now();
    };
    std::atomic<bool> const stop = false;
    ASSERT_TRUE(stream_log(replay, output, std::nullopt, stop, clock));
    read += other.read_now();
    EXPECT_EQ(read.substr(read.size() - end_line().size()), end_line());
    EXPECT_EQ(read.find("\"lost\""), std::string::npos) << "the log waits for who reads";
    EXPECT_LT(now, Timestamp(2 * LineServer::kPatience)) << "and once for who does not";
    EXPECT_NE(stuck.read_now(), "");
}

} // namespace
} // namespace tractus::stream
