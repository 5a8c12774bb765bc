#pragma once

#include "app/controllers/calibration_panel_controller.h"
#include "app/controllers/choice_page.h"
#include "app/controllers/drawn_leaf_files.h"
#include "app/controllers/leaf_page.h"
#include "app/controllers/live_cards.h"
#include "app/controllers/mouse_rig.h"
#include "app/controllers/start_page_controller.h"
#include "app/controllers/station_controller.h"
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
    tools::Methods methods {}; // Methods that can be used.
    // No value: that of a log among the devices, else see create().
    std::optional<calib::Rig> rig {};
    // Where calibrating keeps the rig; empty: nowhere, and there is no calibrating.
    std::filesystem::path rig_file {};
    // How far strokes have to get, by the tools' words, where a person wants it otherwise than as
    // usual (tools::usual_least_extents()).
    tools::LeastExtents least_extents {};
    // The surface's height in place of a height sensor, above the controller.
    std::optional<double> height_mm {};
    scene::Scene scene {}; // The scene that the pen works on; its base plant is loaded.
    // The folder in which saved pictures, exports, and recordings that nobody named appear.
    std::filesystem::path folder = ".";
    std::filesystem::path recording {}; // The new log of all that comes; empty: none at first.
    // Keeps what is drawn; the pen works on its scene in place of the one above. LiveWindow::create
    // takes it over.
    std::optional<session::Session> session {};
    std::function<Timestamp()> now {}; // The clock of the reports.
    // The time that `now` tells, where it goes on by each advance()'s step and by nothing else.
    std::shared_ptr<Timestamp> counted_time {};
    // Stands in for the pen, the height sensor, or both, where the devices lack them; `height_mm`
    // is where its surface is at first.
    std::optional<MouseRig> mouse {};
    // What the window shows before there is a drawing, and between two: at first, if it is open.
    // Null: nothing; then it ends with its drawing.
    std::unique_ptr<StartPageController> start_page {};
    // The session's file that goes away if nothing was drawn in it; may be null. Shared with who
    // takes that of the last drawing away when the window is closed: this one does so before it
    // opens the next.
    std::shared_ptr<std::filesystem::path> unnamed {};
    // Folders of pictures that may be laid behind what is drawn; and where small ones of them are
    // kept; empty: nowhere.
    std::vector<std::filesystem::path> picture_folders {};
    std::filesystem::path cache {};
    std::filesystem::path picture {}; // One to be laid there at first; empty: none.
    std::filesystem::path leaves {};  // The folder of a person's own leaf grammars.
    std::filesystem::path cards {};   // The folder of a person's own cards; empty: none are kept.
    // The model whose plant is drawn on: when it is saved, the plant follows. Empty: none.
    std::filesystem::path model {};
    // The name of a socket at which other programs are told what is drawn; empty: none.
    std::filesystem::path socket {};
};

// Contents of the station's window while somebody draws: devices are read on threads of their own,
// and each advance() takes what they have sent. Devices may go away and come back meanwhile.
class LiveWindow final : public view::WindowModel {
public:
    // Fails like Station::create, LiveRecorder::create and LineServer::listen. Without a height
    // sensor and a height the surface lies on the controller; so it does where there is a height
    // sensor and nothing is known of what its readings mean, and the window opens with calibrating
    // it. Where that cannot be kept, it fails, as the user's fault.
    static Result<LiveWindow> create(devices::LiveDevices devices, LiveWindowOptions options);
    LiveWindow(LiveWindow&&) = default;
    LiveWindow& operator=(LiveWindow&&) = delete;
    ~LiveWindow() override; // Closes, if that was not done.

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
    // The scene that is shown.
    scene::Scene const& scene() const { return *controller_->view().grown_scene(); }

private:
    enum class ChoiceOf { Picture, Leaves };

    LiveWindow(devices::LiveDevices devices, LiveWindowOptions options,
               station::StationOptions station_options, station::Station station);

    void perform_kind(view::SetPlaying const&) { } // A hand has no pause,
    void perform_kind(view::SetSpeed const&) { }   // nor another speed.
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
    bool brings_leaf(std::filesystem::path const& file);
    void open_leaf_page(std::filesystem::path const& file);
    void follow_choices();
    void follow_leaf_page();
    void follow(std::filesystem::path const& model);
    void follow_model();
    void take_reports();
    void choose_for_hand(drivers::LogTool const& line);
    void tell_programs();
    void show_devices();
    void calibrate();
    void use_rig(calib::Rig const& rig);
    void go_on_with(station::Station station);
    void record_tool_changes();
    void record_steps();
    void tell_device_changes();
    void tell_who_is_away();
    void tell_what_is_lost();
    Result<void> start_recording(std::filesystem::path const& path);
    Result<void> stop_recording();
    void flush_recording();

    devices::LiveDevices devices_;
    LiveWindowOptions options_;
    station::StationOptions station_options_; // To begin again.
    station::Station station_;
    std::optional<StationController> controller_; // Of the drawing at hand; never without.
    LiveCards cards_;
    std::unique_ptr<ChoicePage> choices_;         // Null before it is opened,
    ChoiceOf choice_of_ = ChoiceOf::Picture;      // and of what it is.
    std::vector<DrawnLeafFile> drawn_leaves_ {};  // The document's, among the choices,
    std::vector<DrawnOrganFile> drawn_organs_ {}; // as those in three views,
    std::filesystem::path kept_leaf_ {};          // and this one that it wears; may be empty.
    std::unique_ptr<LeafPage> leaf_page_;         // Null before it is opened.
    std::optional<io::FollowedModel> model_;      // Its file, where somebody may write it.
    std::optional<devices::LiveRecorder> recorder_;
    std::optional<stream::StreamOutput> stream_; // No value: nobody wants to be told.
    std::vector<station::PenMoment> moments_;    // What the pen did and is not shown yet.
    // Number of the recording's first stroke in the document.
    std::size_t recorded_from_stroke_ = 0;
    std::optional<devices::LiveDiagnosis> diagnosis_; // While the devices are watched.
    Timestamp next_look_ {};                          // Time of the next look at what it found.
    std::optional<CalibrationPanelController> calibration_; // While a person calibrates.
    std::vector<Eigen::AlignedBox2d> pressing_areas_;
    std::vector<devices::LiveReport> reports_;        // Kept for its memory.
    std::vector<devices::LiveDevices::State> states_; // States that the person was told.
    std::uint64_t lost_reports_ = 0;                  // Likewise.
};

} // namespace tractus::controllers
