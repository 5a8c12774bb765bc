#include "app/commands/watch.h"

#include "app/commands/device_sources.h"
#include "app/devices/live_devices.h"
#include "app/devices/live_recorder.h"
#include "app/devices/watch_view.h"
#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/diagnose.h"
#include "app/options/checks.h"
#include "app/terminal/console.h"
#include "app/terminal/terminal.h"

#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tractus::commands {

namespace {

using namespace std::chrono_literals;

// Time between updates of the screen; faster ones could not be read.
constexpr Duration kScreenPeriod = 100ms;
constexpr Duration kPlainPeriod = 1s;
constexpr std::size_t kPlainWidth = 200;

struct WatchArguments {
    std::vector<std::string> devices;
    std::optional<double> seconds;
};

Timestamp now()
{
    return Timestamp(diagnosis::read_clocks().monotonic);
}

// The watched devices, their statistics and, while one is running, the recording.
class Watch {
public:
    explicit Watch(devices::LiveDevices devices)
        : devices_(std::move(devices))
    {
        for (auto const& info : devices_.infos())
            monitors_.emplace_back(info);
    }

    // Processes new reports; returns false if there were none.
    Result<bool> step()
    {
        devices_.take(reports_);
        for (auto const& report : reports_) {
            monitors_[report.device].push(report.report);
            if (recorder_)
                recorder_->write(report);
        }
        for (auto& monitor : monitors_)
            monitor.pass_time(now());
        if (recorder_)
            TRY(recorder_->flush_if_due(now()));
        return !reports_.empty();
    }

    bool goes_on() const { return devices_.any_left(); }

    std::vector<std::string> lines(std::size_t width) const
    {
        std::vector<diagnosis::DeviceReading> readings;
        for (auto const& monitor : monitors_)
            readings.push_back(monitor.reading());
        return devices::watch_lines(readings, width);
    }

    // Starts a recording in the working folder, or ends the current one.
    Result<void> toggle_recording()
    {
        if (recorder_) {
            TRY(recorder_->flush());
            status_ = fmt::format("recorded {}", recording_);
            recorder_.reset();
            return {};
        }
        recording_ = fmt::format("watch-{:%Y-%m-%d-%H%M%S}.tractus-log",
                                 fmt::localtime(std::time(nullptr)));
        auto recorder = devices::LiveRecorder::create(
            recording_,
            { .devices = devices_.infos(), .rig_text = devices_.rig_text(), .start = now() });
        if (!recorder) {
            status_ = recorder.error().message;
            return {};
        }
        recorder_ = *std::move(recorder);
        return {};
    }

    std::string status() const
    {
        return fmt::format(" q quit  r {}  {}", recorder_ ? "end recording" : "record",
                           recorder_ ? fmt::format("recording {}: {} reports", recording_,
                                                   recorder_->report_count())
                                     : status_);
    }

private:
    devices::LiveDevices devices_;
    std::vector<diagnosis::DeviceMonitor> monitors_; // Statistics of each device.
    // New reports of the devices. A member, so that its memory is reused.
    std::vector<devices::LiveReport> reports_;
    std::optional<devices::LiveRecorder> recorder_;
    std::string recording_; // Path of the current recording.
    std::string status_;
};

Result<void> print_lines(std::vector<std::string> const& lines)
{
    std::string text;
    for (auto const& line : lines)
        text += line + "\n";
    return terminal::print_out(text);
}

// Handles pressed keys; returns true if the user wants to quit.
Result<bool> take_keys(terminal::Terminal& terminal, Watch& watch)
{
    while (auto const key = terminal.key()) {
        if (*key == 'q')
            return true;
        if (*key == 'r')
            TRY(watch.toggle_recording());
    }
    return false;
}

Result<void> run(WatchArguments const& arguments)
{
    Watch watch(TRY(open_devices(arguments.devices, "to watch")));
    std::optional<terminal::Terminal> terminal;
    if (terminal::is_terminal())
        terminal = TRY(terminal::Terminal::open());
    auto const& stop = stop_on_signals();
    auto const begin = now();
    auto next = begin + (terminal ? Duration(0) : kPlainPeriod);
    bool goes_on = true;
    while (goes_on) {
        bool const had_reports = TRY(watch.step());
        bool wants_to_end = false;
        if (terminal)
            wants_to_end = TRY(take_keys(*terminal, watch));
        bool const is_over = arguments.seconds && to_seconds(now() - begin) >= *arguments.seconds;
        // After the end of a log, its last state stays on the screen until the user quits.
        goes_on = !stop && !wants_to_end && !is_over && (terminal || watch.goes_on());
        if (now() >= next || !goes_on) {
            next = now() + (terminal ? kScreenPeriod : kPlainPeriod);
            if (terminal)
                terminal->show(watch.lines(terminal->width()), watch.status());
            else
                TRY(print_lines(watch.lines(kPlainWidth)));
        }
        if (!had_reports)
            std::this_thread::sleep_for(devices::kPollRest);
    }
    return {};
}

} // namespace

void add_watch_command(CLI::App& root, options::Action& action)
{
    auto arguments = std::make_shared<WatchArguments>();
    auto* const command = root.add_subcommand(
        "watch", "Show live what devices send: raw bytes, what they mean, rates and jitter");
    command->add_option(
        "DEVICE", arguments->devices,
        fmt::format("What to watch, each {}; without it, every pen and height sensor "
                    "that is found",
                    devices::device_name_help()));
    command->add_option("--seconds", arguments->seconds, "How long; without it, until q or Ctrl-C")
        ->type_name("SECONDS")
        ->check(options::number(0.001, 1e6));
    command->footer(
        "In a terminal, r begins and ends a recording in the working folder, and q ends. Where\n"
        "the output is no terminal, the same lines are printed each second and at the end.");
    command->callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

} // namespace tractus::commands
