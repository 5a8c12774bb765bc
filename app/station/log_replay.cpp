#include "app/station/log_replay.h"

#include "calib/rig_file.h"
#include "drivers/pen_decoder.h"

#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus {

namespace {

// The first device of the log that is a pen, and its decoder; no decoder if there is none.
struct LogPen {
    std::size_t device = 0;
    std::unique_ptr<PenDecoder> decoder;
};

LogPen find_pen(Log const& log)
{
    for (std::size_t i = 0; i < log.devices.size(); ++i)
        if (auto decoder = make_pen_decoder(log.devices[i]))
            return { i, *std::move(decoder) };
    return {};
}

bool has_height_sensor(Log const& log)
{
    for (auto const& device : log.devices)
        if (make_height_decoder(device))
            return true;
    return false;
}

Result<Rig> choose_rig(Log const& log, LogPen const& pen, ReplayOptions const& options)
{
    if (options.rig)
        return *options.rig;
    if (!log.rig_text.empty())
        return parse_rig(log.rig_text, log.name);
    if (!options.height && has_height_sensor(log))
        return fail(Fault::User,
                    fmt::format("{} has a height sensor but no calibration: give one "
                                "with --rig, or heights with --height",
                                log.name));
    Rig rig;
    if (pen.decoder)
        rig.tablet_size_mm = pen.decoder->traits().size_mm;
    return rig;
}

// Where the scenario's clock begins and ends: at the log's first and last pen sample.
Result<ScriptedHeight> script_height(Log const& log, LogPen const& pen,
                                     HeightScenario const& scenario)
{
    ScriptedHeight scripted { .scenario = scenario };
    bool is_first = true;
    std::vector<PenSample> samples;
    LogCursor cursor(log);
    while (auto const* const report = TRY(cursor.next())) {
        if (!pen.decoder || report->device != pen.device)
            continue;
        samples.clear();
        (void)pen.decoder->decode(report->time, report->bytes, samples);
        if (samples.empty())
            continue;
        if (std::exchange(is_first, false))
            scripted.first_pen = samples.front().time;
        scripted.last_pen = samples.back().time;
    }
    return scripted;
}

} // namespace

Result<LogReplay> LogReplay::create(Log const& log, ReplayOptions options)
{
    auto const pen = find_pen(log);
    StationOptions station_options;
    station_options.rig = TRY(choose_rig(log, pen, options));
    if (options.height)
        station_options.scripted_height = TRY(script_height(log, pen, *options.height));
    station_options.scene = std::move(options.scene);

    std::vector<Tool> tools;
    for (auto const& line : log.tools) {
        auto tool = parse_tool(line.tool, line.arguments);
        if (!tool)
            return fail(Fault::User,
                        fmt::format("{}: tool line at {:.6f} s: {}", log.name,
                                    to_seconds(line.time), tool.error().message));
        tools.push_back(*tool);
    }
    auto station = Station::create(log.devices, std::move(station_options));
    if (!station)
        return fail(station.error().fault,
                    fmt::format("{}: {}", log.name, station.error().message));
    return LogReplay(log, *std::move(station), std::move(tools));
}

LogReplay::LogReplay(Log const& log, Station station, std::vector<Tool> tools)
    : log_(&log)
    , station_(std::move(station))
    , tools_(std::move(tools))
    , cursor_(log)
{
}

void LogReplay::push_tools()
{
    for (; next_tool_ < tools_.size() && log_->tools[next_tool_].position <= cursor_.position();
         ++next_tool_)
        station_.set_tool(log_->tools[next_tool_].time, tools_[next_tool_]);
}

bool LogReplay::advance_to(Timestamp time)
{
    while (advance_to_stroke(time)) { }
    return !finished_;
}

bool LogReplay::advance_to_stroke(Timestamp time)
{
    auto const strokes = station_.counts().strokes;
    for (;;) {
        auto const report = cursor_.peek();
        if (!report)
            outcome_ = tl::unexpected(report.error());
        if (!report || !*report)
            break;
        if ((*report)->time > time)
            return false;
        push_tools();
        station_.push((*report)->device, (*report)->time, (*report)->bytes);
        cursor_.skip();
        if (station_.counts().strokes != strokes)
            return true;
    }
    if (!std::exchange(finished_, true))
        station_.finish();
    return false;
}

Timestamp LogReplay::begin() const
{
    return log_->begin();
}

Timestamp LogReplay::end() const
{
    return log_->end();
}

} // namespace tractus
