#include "app/stream/stream_drawing.h"

#include "app/devices/device_news.h"
#include "app/play/paced_log.h"

#include <chrono>
#include <vector>

namespace tractus::stream {

using namespace std::chrono_literals;

static constexpr Duration kStreamRest = 2ms;

// Writes the station's new output. Strokes are not applied to any drawing, so plants that grow
// along strokes always grow on an empty sheet.
static Result<void> take(station::Station& station, StreamOutput& output)
{
    static scene::Scene const sheet;
    return output.take(station, sheet);
}

// Serves readers until `holds` returns true or `stop` is set.
template<typename Condition>
static void serve_until(StreamOutput& output, play::Pace const& pace, std::atomic<bool> const& stop,
                        Condition const& holds)
{
    output.serve(pace.now());
    while (!holds() && !stop) {
        pace.wait(kStreamRest);
        output.serve(pace.now());
    }
}

// Streams all reports of the log that have its next time stamp.
static Result<void> stream_moment(station::LogReplay& replay, StreamOutput& output)
{
    auto const time = replay.next_time();
    bool is_stroke_end = true;
    while (is_stroke_end) {
        is_stroke_end = replay.advance_to_stroke(time);
        TRY(take(replay.station(), output));
    }
    return {};
}

Result<void> stream_log(station::LogReplay& replay, StreamOutput& output,
                        std::optional<double> speed, std::atomic<bool> const& stop, play::Pace pace)
{
    serve_until(output, pace, stop, [&] { return output.has_readers(); });
    pace.data_begin = replay.begin();
    pace.real_begin = pace.now();
    pace.speed = speed.value_or(1);
    while (!replay.is_over() && !stop) {
        if (speed)
            serve_until(output, pace, stop, [&] {
                return replay.next_time() == Timestamp::max()
                    || pace.data_time(pace.now()) >= replay.next_time();
            });
        else
            serve_until(output, pace, stop,
                        [&] { return output.waiting_bytes() < LineServer::kMaxWaiting; });
        TRY(stream_moment(replay, output));
    }
    if (!stop)
        TRY(output.end());
    serve_until(output, pace, stop, [&] { return output.waiting_bytes() == 0; });
    return replay.outcome();
}

// Serves readers for at most a second, so that they can fetch the remaining data.
static void serve_rest(StreamOutput& output, devices::LiveRecordingOptions const& options)
{
    auto const end = options.now() + Duration(1s);
    output.serve(options.now());
    while (output.waiting_bytes() > 0 && options.now() < end) {
        options.rest(kStreamRest);
        output.serve(options.now());
    }
}

Result<void> stream_live(devices::LiveDevices& devices, station::Station& station,
                         StreamOutput& output, devices::LiveRecordingOptions const& options,
                         std::atomic<bool> const& stop)
{
    auto const start = options.now();
    std::vector<devices::LiveReport> reports;
    devices::DeviceNews news(devices);
    for (bool goes_on = true; goes_on;) {
        goes_on = !stop && devices.any_left()
            && (!options.seconds || to_seconds(options.now() - start) < *options.seconds);
        devices.take(reports);
        for (auto const& [device, report] : reports) {
            station.push(device, report.received, report.bytes());
            TRY(take(station, output));
        }
        station.pass_time(options.now());
        TRY(take(station, output));
        output.serve(options.now());
        news.tell(devices);
        if (reports.empty() && goes_on)
            options.rest(kStreamRest);
    }
    station.finish();
    TRY(take(station, output));
    TRY(output.end());
    serve_rest(output, options);
    return {};
}

} // namespace tractus::stream
