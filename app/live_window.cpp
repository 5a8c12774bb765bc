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
    , view_(station_, options_.pictures)
    , states_(devices_.infos().size(), LiveDevices::State::Connected)
{
    view_.state().is_live = true;
    view_.state().playing = false;
    view_.state().has_session = options_.session.has_value();
    view_.state().status = "Draw: the station reads the pen";
}

void LiveWindow::advance(Duration)
{
    take_reports();
    keep_strokes(); // Before they are seen to be done.
    view_.show(station_);
    tell_what_is_not_kept();
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

// What could not be kept, since the disk was full, say, is tried again.
void LiveWindow::keep_strokes()
{
    constexpr Duration kPatience = std::chrono::seconds(1);
    if (!options_.session || (!not_kept_.empty() && options_.now() < next_try_))
        return;
    not_kept_.clear();
    for (auto const& strokes = station_.strokes(); kept_strokes_ < strokes.size();
         ++kept_strokes_) {
        auto const kept = options_.session->append(strokes[kept_strokes_].edits);
        if (!kept) {
            not_kept_ = kept.error().message;
            next_try_ = options_.now() + kPatience;
            return;
        }
    }
}

void LiveWindow::tell_what_is_not_kept()
{
    if (!not_kept_.empty())
        view_.state().trouble = fmt::format("What is drawn is not kept: {}", not_kept_);
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
            view_.state().status = fmt::format("{} is back", name);
            break;
        case LiveDevices::State::Away: // See tell_who_is_away().
            break;
        case LiveDevices::State::Ended:
            view_.state().status = fmt::format("{} is over", name);
            break;
        }
    }
}

// More urgent than what else may be wrong.
void LiveWindow::tell_who_is_away()
{
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (states_[i] == LiveDevices::State::Away)
            view_.state().trouble = fmt::format(
                "{} has gone: plug it in again, what was drawn is kept", devices_.infos()[i].name);
}

void LiveWindow::stop_recording(std::string const& why)
{
    recorder_.reset();
    view_.state().status = fmt::format("The recording has stopped: {}", why);
}

void LiveWindow::perform(WindowCommand const& command)
{
    std::visit([this](auto const& kind) { perform_kind(kind); }, command);
}

// Shows what the session has become.
void LiveWindow::show_session(Result<void> const& done, std::string const& status)
{
    if (done) {
        station_.set_scene(options_.session->scene());
        view_.begin_again(station_);
    }
    view_.state().status = done ? status : done.error().message;
}

void LiveWindow::perform_kind(Undo const&)
{
    // What is not kept yet would be lost.
    if (options_.session && not_kept_.empty())
        show_session(options_.session->undo(), "Undone");
}

void LiveWindow::perform_kind(Redo const&)
{
    if (options_.session && not_kept_.empty())
        show_session(options_.session->redo(), "Done again");
}

// A step like another: it can be undone.
void LiveWindow::restart_session()
{
    std::vector<Edit> beginning;
    for (auto const& [step, edit, made] : options_.session->contents().edits)
        if (step == 0)
            beginning.push_back(edit);
    if (not_kept_.empty())
        show_session(options_.session->append(beginning), "The session is as it began");
}

void LiveWindow::perform_kind(Restart const&)
{
    if (options_.session)
        return restart_session();
    auto again = Station::create(devices_.infos(), station_options_);
    if (!again) {
        view_.state().status = again.error().message;
        return;
    }
    auto const tool = station_.tool();
    station_ = *std::move(again);
    station_.set_tool(options_.now(), tool);
    view_.begin_again(station_);
    view_.state().status = "The plant is as its model gives it";
}

void LiveWindow::perform_kind(NextVariation const&)
{
    view_.show_next_variation(station_);
}

void LiveWindow::perform_kind(SavePicture const& command)
{
    view_.save(command.picture, station_);
}

void LiveWindow::perform_kind(ChooseTool const& command)
{
    auto const now = options_.now();
    station_.set_tool(now, command.tool);
    if (recorder_) {
        auto const words = words_for(command.tool);
        recorder_->write_tool(now, words.name, words.arguments);
    }
    view_.show(station_);
}

} // namespace tractus
