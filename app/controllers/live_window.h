#pragma once

#include "app/controllers/calibration_panel_controller.h"
#include "app/controllers/choice_page.h"
#include "app/controllers/drawn_leaf_files.h"
#include "app/controllers/leaf_page.h"
#include "app/controllers/live_cards.h"
#include "app/controllers/mouse_rig.h"
#include "app/controllers/start_page_controller.h"
#include "app/controllers/station_controller.h"
#include "app/controllers/tour.h"
#include "app/devices/live_devices.h"
#include "app/devices/live_diagnosis.h"
#include "app/devices/live_recorder.h"
#include "app/io/followed_model.h"
#include "app/session/session.h"
#include "app/stream/stream_output.h"
#include "app/tools/methods.h"
#include "app/view/window_model.h"
#include "calib/rig.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::controllers {

struct LiveWindowOptions {
    tools::Methods methods {}; // Methods that are available in the window.
    // Rig with the calibration of the devices; nullopt: choose_rig() chooses one.
    std::optional<calib::Rig> rig {};
    // File in which a calibration is saved; empty: the window cannot calibrate.
    std::filesystem::path rig_file {};
    // Minimum extents of strokes by tool name, where they differ from tools::usual_min_extents().
    tools::MinExtents min_extents {};
    // Fixed height of the surface above the controller; replaces a height sensor.
    std::optional<double> height_mm {};
    scene::Scene scene {}; // The scene to draw on. Its base plant must be loaded.
    // Folder for saved pictures, exports, and recordings with generated names.
    std::filesystem::path folder = ".";
    // File for a new log of all input; empty: the window does not record at first.
    std::filesystem::path recording {};
    // Session that saves the drawing; its scene replaces `scene`. LiveWindow::create() takes
    // ownership.
    std::optional<session::Session> session {};
    std::function<Timestamp()> now {}; // Clock that gives reports their time.
    // The time that `now` returns, if only advance() moves it on; null if `now` is a real clock.
    std::shared_ptr<Timestamp> counted_time {};
    // Mouse that replaces a missing pen or height sensor; the surface begins at `height_mm`.
    std::optional<MouseRig> mouse {};
    // The start page, shown between drawings and, if it is already open, before the first drawing.
    // Null: there is no start page, and the window closes together with its drawing.
    std::unique_ptr<StartPageController> start_page {};
    // File of the current session if it has a generated name; it is deleted if nothing was drawn.
    // May be null. The window deletes it before it opens another drawing; the caller, who shares
    // this object, deletes it after the window is closed.
    std::shared_ptr<std::filesystem::path> unnamed {};
    // Folders whose pictures can be laid behind the drawing. `cache` is the cache folder for their
    // thumbnails; empty: they are not cached.
    std::vector<std::filesystem::path> picture_folders {};
    std::filesystem::path cache {};
    // Picture to lay behind the drawing at the start; empty: none.
    std::filesystem::path picture {};
    std::filesystem::path leaves {}; // Folder of the user's own leaf grammars.
    std::filesystem::path cards {};  // Folder of the user's own cards; empty: none.
    // File of the drawn plant's model; whenever it is saved, the plant is updated. Empty: none.
    std::filesystem::path model {};
    // Path of a socket on which other programs receive the drawing live; empty: none.
    std::filesystem::path socket {};
    bool begins_tour = false; // True: the window begins with the tour, if no start page is open.
};

// The station's window for live drawing. Each device is read on its own thread, and advance()
// processes the reports. Devices may be unplugged and plugged in again.
class LiveWindow final : public view::WindowModel {
public:
    // Fails like Station::create(), LiveRecorder::create() and LineServer::listen(). Without a
    // height sensor or a fixed height, the surface is assumed to lie on the controller. This also
    // applies to an uncalibrated height sensor: the window then opens with the calibration page,
    // and creation fails with a user error if a calibration could not be saved.
    static Result<LiveWindow> create(devices::LiveDevices devices, LiveWindowOptions options);
    LiveWindow(LiveWindow&&) = default;
    LiveWindow& operator=(LiveWindow&&) = delete;
    ~LiveWindow() override; // Closes the window if close() has not been called.

    void advance(Duration real_step) override;
    void settle() override;
    bool may_close() override { return controller_->may_close(finish()); }
    Result<void> close() override;
    view::WindowState const& state() const override { return controller_->view().state(); }
    void perform(view::WindowCommand const& command) override;
    view::StartPageModel* start_page() override;
    calibration::CalibrationModel* calibration() override
    {
        return calibration_ ? &*calibration_ : nullptr;
    }

    station::Station const& station() const { return station_; }
    document::Document const& document() const { return controller_->document(); }
    // Returns the scene that the window shows.
    scene::Scene const& scene() const { return *controller_->view().grown_scene(); }

private:
    enum class ChoiceOf { Picture, Leaves };

    // Devices, the options of the station that reads them, and what the window's state says of
    // them.
    struct DevicesInUse {
        devices::LiveDevices devices;
        station::StationOptions station_options;
        bool mouse_draws = false;
        bool is_hand_simulated = false;
        bool mouse_moves_surface = false;
        bool may_calibrate = false;
    };

    LiveWindow(devices::LiveDevices devices, LiveWindowOptions options,
               station::StationOptions station_options, station::Station station);

    void perform_kind(view::SetPlaying const&) { } // Live drawing cannot be paused.
    void perform_kind(view::SetSpeed const&) { }   // The speed of live drawing cannot be changed.
    void perform_kind(view::Restart const&);
    void perform_kind(view::ChooseTool const& command);
    void perform_kind(view::AdjustTool const& command);
    void perform_kind(view::TakeLikeDrawn const&);
    void perform_kind(view::KeepCard const& command) { cards_.perform(command, view().state()); }
    void perform_kind(view::RenameCard const& command) { cards_.perform(command, view().state()); }
    void perform_kind(view::RemoveCard const& command) { cards_.perform(command, view().state()); }
    void perform_kind(view::SetPressingAreas const& command);
    void perform_kind(view::PressInstead const&);
    void perform_kind(view::MoveMousePen const& command);
    void perform_kind(view::MoveSurface const& command);
    void perform_kind(view::SetRecording const& command);
    void perform_kind(view::WatchDevices const& command);
    void perform_kind(view::OpenCalibration const&);
    void perform_kind(view::CloseCalibration const&);
    void perform_kind(view::OpenStartPage const&);
    void perform_kind(view::OpenPictures const&);
    void perform_kind(view::OpenLeaves const&);
    void perform_kind(view::LayPictureFile const& command);
    void perform_kind(view::BeginTour const&);
    void perform_kind(view::SkipTourStep const&);
    void perform_kind(view::EndTour const&);
    template<typename Command> void perform_kind(Command const& command)
    {
        controller_->perform(command, station_);
    }

    view::StationView& view() { return controller_->view(); }
    Result<void> finish();
    std::string leave_drawing();
    void go_on_with(OpenedDrawing drawing);
    bool drawings_are_open() const;
    void follow_start_page();
    void take_tool_for_drawing();
    void open_choices(ChoiceOf what, Choices choices);
    LeavesInDocument leaves_in_document();
    void keep_drawn_leaf(std::filesystem::path const& file);
    bool inserts_leaf(std::filesystem::path const& file);
    void open_leaf_page(std::filesystem::path const& file);
    void follow_choices();
    void follow_leaf_page();
    void follow(std::filesystem::path const& model);
    void follow_model();
    Result<DevicesInUse> devices_of_tour() const;
    Result<void> exchange_devices(DevicesInUse& other);
    void give_devices_back();
    void follow_tour();
    void show_tour();
    void take_reports();
    void choose_for_hand(drivers::LogTool const& line);
    void announce_programs();
    void show_devices();
    void calibrate();
    void use_rig(calib::Rig const& rig);
    void go_on_with(station::Station station);
    void record_tool_changes();
    void record_steps();
    void tell_device_changes();
    void announce_missing_devices();
    void warn_of_lost_steps();
    Result<void> start_recording(std::filesystem::path const& path);
    Result<void> stop_recording();
    void flush_recording();

    devices::LiveDevices devices_;
    LiveWindowOptions options_;
    // Options of the station, from which another station is created for a new drawing or rig.
    station::StationOptions station_options_;
    station::Station station_;
    // Controller of the current drawing; always has a value.
    std::optional<StationController> controller_;
    LiveCards cards_;
    // Page on which the user chooses a picture or leaf; null until first opened.
    std::unique_ptr<ChoicePage> choices_;
    // What the user chooses on choices_: a picture or leaves.
    ChoiceOf choice_of_ = ChoiceOf::Picture;
    // Files of the document's drawn leaves that are among the choices.
    std::vector<DrawnLeafFile> drawn_leaves_ {};
    // Files of leaves drawn in three views that are among the choices.
    std::vector<DrawnOrganFile> drawn_organs_ {};
    // File of the plant's current foliage, if the document contains its grammar; otherwise empty.
    std::filesystem::path kept_leaf_ {};
    std::unique_ptr<LeafPage> leaf_page_;    // Page that previews leaves; null until first opened.
    std::optional<io::FollowedModel> model_; // The plant's model file, watched for changes.
    std::optional<devices::LiveRecorder> recorder_;
    // Streams the drawing to other programs; nullopt if it is not streamed.
    std::optional<stream::StreamOutput> stream_;
    std::vector<station::PenMoment> moments_; // Pen input that has not been shown yet.
    // Number of strokes in the document when the recording began.
    std::size_t recorded_from_stroke_ = 0;
    // Diagnosis of the devices, while the devices page is open.
    std::optional<devices::LiveDiagnosis> diagnosis_;
    Timestamp next_look_ {}; // Time at which the devices page is next updated with the diagnosis.
    // Controller of the calibration page; nullopt if that page is closed.
    std::optional<CalibrationPanelController> calibration_;
    std::optional<Tour> tour_;
    std::size_t shown_tour_step_ = 0; // Step of the tour for which a tool was chosen last.
    // The user's devices while the tour's hand draws; otherwise no value.
    std::optional<DevicesInUse> user_devices_;
    std::vector<Eigen::AlignedBox2d> pressing_areas_;
    // New reports of the devices. A member, so that its memory is reused.
    std::vector<devices::LiveReport> reports_;
    // States of the devices as last reported to the user.
    std::vector<devices::LiveDevices::State> states_;
    std::uint64_t lost_reports_ = 0; // Number of lost reports as last reported to the user.
};

} // namespace tractus::controllers
