#include "app/station/log_replay.h"

#include "app/document/logged_step.h"
#include "calib/rig_file.h"
#include "drivers/height_decoders.h"
#include "drivers/tablets/pen_decoders.h"

#include <fmt/core.h>
#include <limits>
#include <memory>
#include <utility>

namespace tractus::station {

namespace {

// The first pen of a log: its index among the devices, and its decoder (null if there is no pen).
struct LogPen {
    std::size_t device = 0;
    std::unique_ptr<drivers::PenDecoder> decoder;
};

LogPen find_pen(drivers::Log const& log)
{
    for (std::size_t i = 0; i < log.devices.size(); ++i)
        if (auto decoder = drivers::make_pen_decoder(log.devices[i]))
            return { i, *std::move(decoder) };
    return {};
}

bool has_height_sensor(drivers::Log const& log)
{
    for (auto const& device : log.devices)
        if (drivers::make_height_decoder(device))
            return true;
    return false;
}

Result<calib::Rig> choose_rig(drivers::Log const& log, LogPen const& pen,
                              ReplayOptions const& options)
{
    if (options.rig)
        return *options.rig;
    if (!log.rig_text.empty())
        return calib::parse_rig(log.rig_text, log.name);
    if (!options.height && has_height_sensor(log))
        return fail(Fault::User,
                    fmt::format("{} has a height sensor but no calibration: give one "
                                "with --rig, or heights with --height",
                                log.name));
    calib::Rig rig;
    if (pen.decoder)
        rig.tablet_size_mm = pen.decoder->traits().size_mm;
    return rig;
}

// Returns the heights of a scenario that is played from the time of the log's first pen sample to
// that of the last.
Result<calib::ScriptedHeight> script_height(drivers::Log const& log, LogPen const& pen,
                                            calib::HeightScenario const& scenario)
{
    calib::ScriptedHeight scripted { .scenario = scenario };
    bool is_first = true;
    std::vector<drivers::PenSample> samples;
    drivers::LogCursor cursor(log);
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

Result<LogReplay> LogReplay::create(drivers::Log const& log, ReplayOptions const& options)
{
    auto const pen = find_pen(log);
    StationOptions station_options;
    station_options.tools = options.methods.tools;
    if (!station_options.tools.empty())
        station_options.tool = tools::default_tool_of_kind(*station_options.tools.front());
    station_options.layers = options.methods.layers;
    station_options.curves = options.methods.curves;
    station_options.rig = TRY(choose_rig(log, pen, options));
    if (options.height)
        station_options.scripted_height = TRY(script_height(log, pen, *options.height));

    std::vector<std::string> left_out;
    auto lines = TRY(read_lines(log, options.methods, left_out));
    auto station = Station::create(log.devices, station_options);
    if (!station)
        return fail(station.error().fault,
                    fmt::format("{}: {}", log.name, station.error().message));
    return LogReplay(log, *std::move(station), std::move(lines), std::move(left_out));
}

// Reads the log's lines about tools, minimum extents and steps. A line with an unknown name comes
// from a program with more tools; strokes drawn with such a tool are left out.
Result<std::vector<LogReplay::Line>> LogReplay::read_lines(drivers::Log const& log,
                                                           tools::Methods const& methods,
                                                           std::vector<std::string>& left_out)
{
    std::vector<Line> lines;
    for (auto const& [time, word, arguments, position] : log.tools) {
        auto const place = fmt::format("{}: tool line at {:.6f} s", log.name, to_seconds(time));
        if (auto step = document::parse_step(word, arguments, methods.edits)) {
            if (!*step)
                return fail(Fault::User, fmt::format("{}: {}", place, step->error().message));
            lines.push_back({ position, time, **std::move(step) });
        } else if (word == tools::kMinExtentsLine) {
            auto extents = tools::parse_min_extents(arguments);
            if (!extents)
                return fail(Fault::User, fmt::format("{}: {}", place, extents.error().message));
            lines.push_back({ position, time, *std::move(extents) });
        } else if (word == pressing().kind().word) {
            lines.push_back({ position, time, pressing() });
        } else if (auto const tool = tools::parse_tool(methods.tools, word, arguments)) {
            lines.push_back({ position, time, *tool });
        } else if (tools::find_tool_kind(methods.tools, word)) {
            return fail(Fault::User, fmt::format("{}: {}", place, tool.error().message));
        } else {
            left_out.push_back(
                fmt::format("{}: {}; its strokes are left out", place, tool.error().message));
            lines.push_back({ position, time, tools::Tool() });
        }
    }
    return lines;
}

LogReplay::LogReplay(drivers::Log const& log, Station station, std::vector<Line> lines,
                     std::vector<std::string> left_out)
    : log_(&log)
    , station_(std::move(station))
    , lines_(std::move(lines))
    , left_out_(std::move(left_out))
    , cursor_(log)
{
}

void LogReplay::push_lines()
{
    for (; next_line_ < lines_.size() && lines_[next_line_].position <= cursor_.position();
         ++next_line_)
        if (auto const* const tool = std::get_if<tools::Tool>(&lines_[next_line_].what))
            station_.set_tool(lines_[next_line_].time, *tool);
        else if (auto const* const extents
                 = std::get_if<tools::MinExtents>(&lines_[next_line_].what))
            station_.set_min_extents(*extents);
}

// Hands each step over after as many strokes as preceded it in the original session. The step's
// line may be later in the log than the reports of later strokes.
void LogReplay::replay_into(document::Document& document)
{
    auto const hand_steps_over = [&](std::size_t end, std::size_t strokes_before) {
        for (; next_step_ < end; ++next_step_) {
            auto const* const step = std::get_if<document::LoggedStep>(&lines_[next_step_].what);
            if (!step)
                continue;
            if (step->strokes_before > strokes_before)
                return;
            document.make(*step);
        }
    };
    for (auto& stroke : station_.take_strokes()) {
        hand_steps_over(lines_.size(), handed_strokes_);
        document.draw(std::move(stroke));
        ++handed_strokes_;
    }
    constexpr auto kAll = std::numeric_limits<std::size_t>::max();
    if (finished_)
        hand_steps_over(lines_.size(), kAll);
    else
        hand_steps_over(next_line_, handed_strokes_);
}

void LogReplay::run(document::Document& document)
{
    bool goes_on = true;
    while (goes_on) {
        goes_on = advance_to_stroke(Timestamp::max());
        replay_into(document);
    }
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
        push_lines();
        station_.push((*report)->device, (*report)->time, (*report)->bytes);
        cursor_.skip();
        if (station_.counts().strokes != strokes)
            return true;
    }
    if (!std::exchange(finished_, true))
        station_.finish();
    return false;
}

Timestamp LogReplay::next_time()
{
    auto const report = cursor_.peek();
    return report && *report ? (*report)->time : Timestamp::max();
}

Timestamp LogReplay::begin() const
{
    return log_->begin();
}

Timestamp LogReplay::end() const
{
    return log_->end();
}

} // namespace tractus::station
