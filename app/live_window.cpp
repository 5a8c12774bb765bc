#include "app/live_window.h"

#include "calib/rig_file.h"
#include "drivers/height_decoder.h"
#include "engine/base/check.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

bool has_height_sensor(LiveDevices const& devices)
{
    return std::any_of(devices.infos().begin(), devices.infos().end(), [](auto const& info) {
        return !make_pen_decoder(info) && make_height_decoder(info);
    });
}

// The size of the first tablet's active area.
std::optional<Vec2> tablet_size_mm(LiveDevices const& devices)
{
    for (auto const& info : devices.infos())
        if (auto const decoder = make_pen_decoder(info))
            return (*decoder)->traits().size_mm;
    return std::nullopt;
}

Result<Rig> choose_rig(LiveDevices const& devices, LiveWindowOptions const& options)
{
    if (options.rig)
        return *options.rig;
    if (!devices.rig_text().empty())
        return parse_rig(devices.rig_text(), "the log's rig");
    if (!options.height_mm && has_height_sensor(devices))
        return fail(Fault::User,
                    "there is a height sensor but no calibration of it: give one with --rig, or "
                    "the surface's height with --height");
    Rig rig;
    rig.tablet_size_mm = tablet_size_mm(devices).value_or(rig.tablet_size_mm);
    return rig;
}

} // namespace

Result<LiveWindow> LiveWindow::create(LiveDevices devices, LiveWindowOptions options)
{
    CHECK(options.now);
    StationOptions station_options;
    station_options.rig = TRY(choose_rig(devices, options));
    station_options.scene = options.session ? options.session->scene() : options.scene;
    if (options.height_mm || !has_height_sensor(devices))
        station_options.scripted_height = ScriptedHeight {
            .scenario = { .kind = HeightScenario::Kind::Constant,
                          .constant_mm = options.height_mm.value_or(0) },
            .first_pen = {},
            .last_pen = {},
        };
    auto station = TRY(Station::create(devices.infos(), station_options));
    LiveWindow window(std::move(devices), std::move(options), std::move(station_options),
                      std::move(station));
    if (!window.options_.recording.empty())
        window.recorder_
            = TRY(LiveRecorder::create(window.options_.recording,
                                       { .devices = window.devices_.infos(),
                                         .rig_text = print_rig(window.station_options_.rig),
                                         .start = window.options_.now() }));
    return window;
}

LiveWindow::LiveWindow(LiveDevices devices, LiveWindowOptions options,
                       StationOptions station_options, Station station)
    : devices_(std::move(devices))
    , options_(std::move(options))
    , station_options_(std::move(station_options))
    , station_(std::move(station))
    , desk_(station_, std::exchange(options_.session, std::nullopt), options_.pictures)
    , states_(devices_.infos().size(), LiveDevices::State::Connected)
{
    view().state().is_live = true;
    view().state().playing = false;
    view().state().status = "Draw: the station reads the pen";
}

void LiveWindow::advance(Duration)
{
    take_reports();
    desk_.show(station_, options_.now());
    tell_device_changes();
    tell_who_is_away();
    if (!recorder_)
        return;
    if (auto const flushed = recorder_->flush_if_due(options_.now()); !flushed)
        stop_recording(flushed.error().message);
}

void LiveWindow::take_reports()
{
    devices_.take(reports_);
    for (auto const& [device, report] : reports_)
        station_.push(device, report.received, report.bytes());
    station_.pass_time(options_.now());
    if (recorder_)
        for (auto const& report : reports_)
            recorder_->write(report);
}

void LiveWindow::tell_device_changes()
{
    for (std::size_t i = 0; i < states_.size(); ++i) {
        auto const state = devices_.state(i);
        if (std::exchange(states_[i], state) == state)
            continue;
        auto const& name = devices_.infos()[i].name;
        switch (state) {
        case LiveDevices::State::Connected:
            view().state().status = fmt::format("{} is back", name);
            break;
        case LiveDevices::State::Away: // See tell_who_is_away().
            break;
        case LiveDevices::State::Ended:
            view().state().status = fmt::format("{} is over", name);
            break;
        }
    }
}

// More urgent than what else may be wrong.
void LiveWindow::tell_who_is_away()
{
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (states_[i] == LiveDevices::State::Away)
            view().state().trouble = fmt::format(
                "{} has gone: plug it in again, what was drawn is kept", devices_.infos()[i].name);
}

void LiveWindow::stop_recording(std::string const& why)
{
    recorder_.reset();
    view().state().status = fmt::format("The recording has stopped: {}", why);
}

void LiveWindow::perform(WindowCommand const& command)
{
    std::visit([this](auto const& kind) { perform_kind(kind); }, command);
}

void LiveWindow::perform_kind(Restart const&)
{
    if (auto& keeper = desk_.keeper(); keeper.has_session())
        desk_.show_again(keeper.begin_again(station_), station_, "The session is as it began");
    else
        restart_without_session();
}

void LiveWindow::restart_without_session()
{
    auto again = Station::create(devices_.infos(), station_options_);
    if (!again) {
        view().state().status = again.error().message;
        return;
    }
    auto const tool = station_.tool();
    station_ = *std::move(again);
    station_.set_tool(options_.now(), tool);
    desk_.show_again({}, station_, "The plant is as its model gives it");
}

void LiveWindow::perform_kind(ChooseTool const& command)
{
    auto const now = options_.now();
    station_.set_tool(now, command.tool);
    if (recorder_) {
        auto const words = words_for(command.tool);
        recorder_->write_tool(now, words.name, words.arguments);
    }
    view().show(station_);
}

} // namespace tractus
