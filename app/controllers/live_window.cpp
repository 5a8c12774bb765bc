#include "app/controllers/live_window.h"

#include "app/calibration/save_calibration.h"
#include "app/controllers/live_rig.h"
#include "app/controllers/rules_file.h"
#include "app/document/logged_step.h"
#include "calib/rig_file.h"
#include "engine/base/check.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::controllers {

namespace {

// Pressure of the mouse as a pen, from 0 to 1: that of relaxed drawing.
constexpr double kMousePressure = 0.5;

} // namespace

Result<LiveWindow> LiveWindow::create(devices::LiveDevices devices, LiveWindowOptions options)
{
    CHECK(options.now && !options.methods.tools.empty());
    station::StationOptions station_options;
    station_options.tools = options.methods.tools;
    station_options.layers = options.methods.layers;
    station_options.curves = options.methods.curves;
    station_options.min_extents = options.min_extents;
    station_options.min_extents.merge(tools::usual_min_extents(options.methods.tools));
    bool const has_sensor = has_height_sensor(devices);
    bool const lacks_calibration = controllers::lacks_calibration(devices, options);
    auto const mouse = add_mouse(devices, options);
    station_options.is_height_watched = !mouse.height;
    station_options.rig = TRY(choose_rig(devices, options, mouse));
    if (!mouse.height && (options.height_mm || !has_sensor || lacks_calibration))
        station_options.scripted_height = calib::ScriptedHeight {
            .scenario = { .kind = calib::HeightScenario::Kind::Constant,
                          .constant_mm = options.height_mm.value_or(0) },
            .first_pen = {},
            .last_pen = {},
        };
    auto station = TRY(station::Station::create(devices.infos(), station_options));
    LiveWindow window(std::move(devices), std::move(options), std::move(station_options),
                      std::move(station));
    window.view().state().mouse_draws = mouse.pen;
    window.view().state().is_hand_simulated = window.devices_.has_hand();
    window.view().state().mouse_moves_surface = mouse.height;
    window.view().state().may_calibrate = has_sensor && !window.options_.rig_file.empty();
    if (auto const note = size_note(window.devices_, window.station_options_.rig))
        window.view().state().status = *note;
    if (!window.drawings_are_open())
        window.take_tool_for_drawing();
    if (lacks_calibration)
        window.perform(view::OpenCalibration {});
    if (!window.options_.recording.empty())
        TRY(window.start_recording(window.options_.recording));
    if (!window.options_.socket.empty())
        window.stream_ = TRY(stream::StreamOutput::open_socket(
            window.options_.socket, window.station_.volume_mm(), stream::StreamOutput::What::All));
    // A command lays the picture, so that this step is recorded, too.
    if (!window.options_.picture.empty())
        window.perform(view::LayPictureFile { window.options_.picture });
    if (window.options_.begins_tour && !window.drawings_are_open())
        window.perform(view::BeginTour {});
    return window;
}

LiveWindow::LiveWindow(devices::LiveDevices devices, LiveWindowOptions options,
                       station::StationOptions station_options, station::Station station)
    : devices_(std::move(devices))
    , options_(std::move(options))
    , station_options_(std::move(station_options))
    , station_(std::move(station))
    , controller_(std::in_place, station_, std::exchange(options_.session, std::nullopt),
                  std::exchange(options_.scene, {}), options_.folder)
    , cards_(options_.cards)
    , states_(devices_.infos().size(), devices::LiveDevices::State::Connected)
{
    view().state().is_live = true;
    view().state().playing = false;
    view().state().may_begin_anew = options_.start_page != nullptr;
    if (!options_.model.empty())
        follow(options_.model);
    // A status that is already set warns of unknown edits in the session.
    if (view().state().status.empty())
        view().state().status = "Draw: the station reads the pen";
}

LiveWindow::~LiveWindow()
{
    static_cast<void>(close());
}

// Ends the current stroke, after processing all reports received so far.
Result<void> LiveWindow::finish()
{
    take_reports();
    station_.finish();
    announce_programs();
    record_tool_changes();
    auto const kept = controller_->finish(station_, options_.now());
    record_steps();
    return kept;
}

Result<void> LiveWindow::close()
{
    if (!options_.now) // This object was moved from: there is nothing to close.
        return {};
    auto const kept = finish();
    auto const recorded = recorder_ ? stop_recording() : Result<void>();
    auto const written = controller_->finish_files();
    if (stream_) {
        static_cast<void>(stream_->end());
        stream_->serve(options_.now());
        stream_.reset();
    }
    if (!kept) // An error in saving the drawing takes precedence over other errors.
        return kept;
    return recorded ? written : recorded;
}

void LiveWindow::advance(Duration real_step)
{
    if (options_.counted_time)
        *options_.counted_time += real_step;
    take_reports();
    announce_programs();
    follow_start_page();
    follow_choices();
    follow_leaf_page();
    follow_model();
    follow_tour();
    controller_->show(station_, options_.now());
    view().pass(real_step);
    if (auto hand = controller_->take_hand())
        perform_kind(view::ChooseTool { *std::move(hand) });
    record_steps();
    view().show_pen(std::exchange(moments_, {}));
    cards_.show(view().state());
    calibrate();
    show_devices();
    tell_device_changes();
    announce_missing_devices();
    warn_of_lost_steps();
    flush_recording();
}

void LiveWindow::settle()
{
    if (options_.start_page) {
        options_.start_page->settle();
        follow_start_page();
    }
    if (choices_)
        choices_->settle();
    if (leaf_page_)
        leaf_page_->settle();
    controller_->settle(station_, options_.now());
}

void LiveWindow::follow(std::filesystem::path const& model)
{
    model_.emplace(model, model_drawn_on(controller_->document().newest()->scene.state));
}

void LiveWindow::follow_model()
{
    if (auto const rules = controller_->take_rules_file())
        follow(*rules);
    if (!model_)
        return;
    if (auto changed = model_->take_change(options_.now()))
        controller_->take_model(*std::move(changed), station_);
}

// Passes reports of the devices to the station and other receivers. A simulated hand does not start
// until a drawing is open.
void LiveWindow::take_reports()
{
    if (!drawings_are_open())
        devices_.start_simulated_hand();
    devices_.take(reports_);
    auto const tools = devices_.take_hand_tools();
    auto next_tool = tools.begin();
    auto const choose_tools_until = [&](Timestamp time) {
        for (; next_tool != tools.end() && next_tool->time <= time; ++next_tool)
            choose_for_hand(*next_tool);
    };
    for (auto const& report : reports_) {
        choose_tools_until(report.report.received);
        station_.push(report.device, report.report.received, report.report.bytes());
        // Tool changes are recorded before the report, so that a stroke that begins with the report
        // belongs to the new tool.
        record_tool_changes();
        if (recorder_)
            recorder_->write(report);
        if (diagnosis_)
            diagnosis_->push(report);
        if (calibration_)
            calibration_->push(report);
    }
    choose_tools_until(Timestamp::max());
    station_.pass_time(options_.now());
}

void LiveWindow::choose_for_hand(drivers::LogTool const& line)
{
    auto const tool = tools::parse_tool(options_.methods.tools, line.tool, line.arguments);
    if (!tool) {
        view().state().status = tool.error().message;
        return;
    }
    station_.set_tool(line.time, *tool);
    record_tool_changes();
}

// Streams the pen's input to other programs, before the document takes the strokes. Never waits for
// a slow client, so nothing can fail.
void LiveWindow::announce_programs()
{
    auto const moments = station_.take_moments();
    moments_.insert(moments_.end(), moments.begin(), moments.end());
    if (!stream_)
        return;
    // New clients are accepted first, so that they also receive the lines written next.
    stream_->serve(options_.now());
    static_cast<void>(stream_->tell(moments, station_, scene()));
    stream_->serve(options_.now());
}

void LiveWindow::record_tool_changes()
{
    for (auto const& [time, tool] : station_.take_tool_changes()) {
        auto const words = tools::words_for(tool);
        if (recorder_)
            recorder_->write_tool(time, words.name, words.arguments);
    }
}

// Records each step together with the number of recorded strokes that precede it, because later
// strokes may have begun before the step is known to be complete.
void LiveWindow::record_steps()
{
    for (auto const& step : controller_->take_done()) {
        if (!recorder_)
            continue;
        auto const words = document::words_for(step, step.strokes_before - recorded_from_stroke_);
        recorder_->write_tool(options_.now(), words.name, words.arguments);
    }
}

void LiveWindow::tell_device_changes()
{
    for (std::size_t i = 0; i < states_.size(); ++i) {
        auto const state = devices_.state(i);
        if (std::exchange(states_[i], state) == state)
            continue;
        auto const& name = devices_.infos()[i].name;
        switch (state) {
        case devices::LiveDevices::State::Connected:
            view().state().status = fmt::format("{} is back", name);
            break;
        // announce_missing_devices() reports disconnected devices.
        case devices::LiveDevices::State::Away:
            break;
        case devices::LiveDevices::State::Ended:
            view().state().status = fmt::format("{} is over", name);
            break;
        }
    }
}

// Shows which devices are disconnected. This message takes precedence over others.
void LiveWindow::announce_missing_devices()
{
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (states_[i] != devices::LiveDevices::State::Away)
            continue;
        auto const refusal = devices_.refusal(i);
        view().state().trouble = refusal.empty()
            ? fmt::format("{} has gone: plug it in again, what was drawn is kept",
                          devices_.infos()[i].name)
            : refusal + "; what was drawn is kept";
    }
}

void LiveWindow::warn_of_lost_steps()
{
    auto const lost = devices_.lost_count();
    if (std::exchange(lost_reports_, lost) < lost)
        view().state().status
            = fmt::format("{} of the devices' reports {} lost: they came faster than they were "
                          "read, or are longer than any pen's",
                          lost, lost == 1 ? "is" : "are");
}

Result<void> LiveWindow::start_recording(std::filesystem::path const& path)
{
    auto const now = options_.now();
    recorder_
        = TRY(devices::LiveRecorder::create(path,
                                            { .devices = devices_.infos(),
                                              .rig_text = calib::print_rig(station_options_.rig),
                                              .start = now }));
    (void)controller_->finish(station_, now);
    (void)controller_->take_done(); // Discards steps done before the recording.
    recorded_from_stroke_ = controller_->document().stroke_count();
    recorder_->write_tool(now, tools::kMinExtentsLine,
                          tools::print_min_extents(station_.min_extents()));
    // Records the tools at both ends of the pen at the start of the recording.
    for (auto const& tool : station_.tools_for_continuation()) {
        auto const words = tools::words_for(tool);
        recorder_->write_tool(now, words.name, words.arguments);
    }
    view().state().recording = { true, path.filename().string(), recorder_->byte_count() };
    return {};
}

Result<void> LiveWindow::stop_recording()
{
    auto const flushed = recorder_->flush();
    view().state().recording.bytes = recorder_->byte_count();
    view().state().recording.is_on = false;
    recorder_.reset();
    return flushed;
}

void LiveWindow::flush_recording()
{
    if (!recorder_)
        return;
    auto const flushed = recorder_->flush_if_due(options_.now());
    view().state().recording.bytes = recorder_->byte_count();
    if (flushed)
        return;
    recorder_.reset();
    view().state().recording.is_on = false;
    view().state().status = fmt::format("The recording has stopped: {}", flushed.error().message);
}

void LiveWindow::perform_kind(view::SetRecording const& command)
{
    if (command.is_on == recorder_.has_value())
        return;
    auto& status = view().state().status;
    if (command.is_on) {
        auto const path = controller_->new_file(".tractus-log");
        auto const begun = start_recording(path);
        status = begun ? fmt::format("Recording into {}", path.string()) : begun.error().message;
        return;
    }
    // Pending steps still belong to the recording.
    (void)controller_->finish(station_, options_.now());
    record_steps();
    auto const stopped = stop_recording();
    auto const& [is_on, file, bytes] = view().state().recording;
    status = stopped ? fmt::format("Recorded {}, {:.1f} kB", file, static_cast<double>(bytes) / 1e3)
                     : stopped.error().message;
}

void LiveWindow::perform(view::WindowCommand const& command)
{
    std::visit([this](auto const& kind) { perform_kind(kind); }, command);
    if (tour_)
        tour_->take(command);
}

void LiveWindow::perform_kind(view::Restart const&)
{
    controller_->begin_again(station_, "The plant is as its model gives it");
}

// Replaces the station. The new one has the same tools selected.
void LiveWindow::go_on_with(station::Station station)
{
    auto const tools = station_.tools_for_continuation();
    station_ = std::move(station);
    station_.set_pressing_areas(pressing_areas_);
    for (auto const& tool : tools)
        station_.set_tool(options_.now(), tool);
}

void LiveWindow::perform_kind(view::ChooseTool const& command)
{
    station_.set_tool(options_.now(), command.tool);
    record_tool_changes();
    controller_->show(station_, options_.now());
}

void LiveWindow::perform_kind(view::AdjustTool const& command)
{
    auto const before = station_.tool();
    if (command.slider == view::ChangeGrowth::Slider::Moving)
        return controller_->preview_following(before, command.tool);
    perform_kind(view::ChooseTool { command.tool });
    controller_->let_follow(before, command.tool, station_);
}

void LiveWindow::perform_kind(view::TakeLikeDrawn const&)
{
    auto const hand = station_.tool();
    auto* const like_drawn = hand.kind().like_drawn;
    auto const tool = like_drawn ? like_drawn(hand, scene()) : std::nullopt;
    if (tool)
        return perform_kind(view::ChooseTool { *tool });
    view().state().status = "The plant that takes what is drawn was drawn in another way";
}

void LiveWindow::perform_kind(view::SetPressingAreas const& command)
{
    pressing_areas_ = command.areas;
    station_.set_pressing_areas(command.areas);
}

void LiveWindow::perform_kind(view::PressInstead const&)
{
    station_.convert_touch_to_press();
    record_tool_changes();
}

void LiveWindow::perform_kind(view::MoveMousePen const& command)
{
    if (!options_.mouse)
        return;
    Vec2 const middle_mm = station_options_.rig.tablet_size_mm / 2;
    std::vector<sim::TabletPen> pens;
    for (auto const& pen : command.path)
        pens.push_back({ .place_mm = pen.place_mm + middle_mm,
                         .in_range = pen.in_range,
                         .touching = pen.touching,
                         .pressure = pen.touching ? kMousePressure : 0 });
    options_.mouse->move_pen(pens);
}

void LiveWindow::perform_kind(view::MoveSurface const& command)
{
    if (options_.mouse)
        options_.mouse->move_surface(command.by_mm);
}

void LiveWindow::perform_kind(view::WatchDevices const& command)
{
    diagnosis_.reset();
    if (command.watched)
        diagnosis_.emplace(devices_, options_.now());
    view().state().devices = {};
    ++view().state().devices_revision;
    next_look_ = options_.now();
}

// Updates the devices page, at intervals long enough for reading it.
void LiveWindow::show_devices()
{
    constexpr Duration kLookEvery = std::chrono::milliseconds(100);
    auto const now = options_.now();
    if (!diagnosis_ || now < next_look_)
        return;
    next_look_ = now + kLookEvery;
    diagnosis_->pass_time(now);
    view().state().devices = { diagnosis_->readings(), diagnosis_->findings() };
    ++view().state().devices_revision;
}

void LiveWindow::perform_kind(view::OpenCalibration const&)
{
    if (!view().state().may_calibrate)
        return;
    auto panel = CalibrationPanelController::create(
        devices_.infos(),
        { .controller = { .rig = station_options_.rig },
          .date = calibration::today(),
          .now = options_.now,
          .keep = [file = options_.rig_file](calibration::CalibrationOutcome const& outcome) {
              std::error_code ignored; // An error is ignored here: saving reports it.
              std::filesystem::create_directories(file.parent_path(), ignored);
              return calibration::save_calibration(outcome, file);
          } });
    if (panel)
        calibration_ = *std::move(panel);
    else
        view().state().status = panel.error().message;
}

void LiveWindow::perform_kind(view::CloseCalibration const&)
{
    calibration_.reset();
    ++view().state().live_revision; // Makes the views redraw, as they are visible again.
}

void LiveWindow::calibrate()
{
    if (!calibration_)
        return;
    calibration_->advance();
    if (auto const rig = calibration_->take_kept_rig())
        use_rig(*rig);
}

// From now on, draws with this rig.
void LiveWindow::use_rig(calib::Rig const& rig)
{
    auto options = station_options_;
    options.rig = rig;
    options.scripted_height.reset();
    auto station = station::Station::create(devices_.infos(), options);
    if (!station) {
        view().state().status = station.error().message;
        return;
    }
    station_.finish();
    announce_programs();
    record_tool_changes();
    // An error in saving is only shown in the status: saving unsaved steps is tried again later.
    auto const kept = controller_->finish(station_, options_.now());
    station_options_ = std::move(options);
    go_on_with(*std::move(station));
    controller_->show_again(station_,
                            kept ? "The pen draws by the new calibration" : kept.error().message);
    if (recorder_) // A recording ends here, as its log's header contains the old rig.
        perform_kind(view::SetRecording { false });
}

} // namespace tractus::controllers
