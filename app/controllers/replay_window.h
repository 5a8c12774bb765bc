#pragma once

#include "app/controllers/station_controller.h"
#include "app/station/log_replay.h"
#include "app/view/window_model.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <optional>

namespace tractus::controllers {

// The station's window while a log is replayed at its original pace. Shows the pen, the strokes,
// the selection, and the plant, which is updated after each stroke.
class ReplayWindow final : public view::WindowModel {
public:
    // The log must outlive the window. `pictures` is the folder for saved pictures. With a session,
    // the replay draws on the session's scene instead of `scene` and saves the drawing there. Fails
    // like LogReplay::create().
    static Result<ReplayWindow> create(drivers::Log const& log, station::ReplayOptions options,
                                       scene::Scene scene, std::filesystem::path pictures,
                                       std::optional<session::Session> session = {});

    ReplayWindow(ReplayWindow&&) = default;
    ReplayWindow& operator=(ReplayWindow&&) = delete;
    ~ReplayWindow() override; // Closes the window if close() has not been called.

    void advance(Duration real_step) override;
    void settle() override { controller_.settle(replay_.station(), now_); }
    bool may_close() override { return controller_.may_close(finish()); }
    Result<void> close() override;
    view::WindowState const& state() const override { return controller_.view().state(); }
    void perform(view::WindowCommand const& command) override;

private:
    Result<void> finish();
    ReplayWindow(drivers::Log const& log, station::ReplayOptions options, station::LogReplay replay,
                 StationController controller);

    void perform_kind(view::SetPlaying const& command);
    void perform_kind(view::SetSpeed const& command);
    void perform_kind(view::Restart const&);
    // Tools, pictures and leaves cannot be chosen: the replay uses those that were recorded.
    void perform_kind(view::ChooseTool const&) { }
    void perform_kind(view::AdjustTool const&) { }
    void perform_kind(view::TakeLikeDrawn const&) { }
    void perform_kind(view::KeepCard const&) { }
    void perform_kind(view::RenameCard const&) { }
    void perform_kind(view::RemoveCard const&) { }
    void perform_kind(view::OpenPictures const&) { }
    void perform_kind(view::LayPictureFile const&) { }
    void perform_kind(view::DragDrawnGizmo const&) { }
    void perform_kind(view::OpenLeaves const&) { }
    void perform_kind(view::SetActiveFoliage const&) { }
    void perform_kind(view::BringLeaf const&) { }
    // Curves cannot be picked, as the selection is as recorded.
    void perform_kind(view::PickCurve const&) { }
    // The drawing cannot be named, as a recording has no name to change.
    void perform_kind(view::NameDrawing const&) { }
    void perform_kind(view::SaveCopy const&) { }
    void perform_kind(view::WriteRules const&) { }
    void perform_kind(view::BeginTour const&) { }
    void perform_kind(view::SkipTourStep const&) { }
    void perform_kind(view::EndTour const&) { }
    // Pressing has no effect, as the window's controls were in other places during the recording.
    void perform_kind(view::SetPressingAreas const&) { }
    void perform_kind(view::PressInstead const&) { }
    void perform_kind(view::MoveMousePen const&) { }
    void perform_kind(view::MoveSurface const&) { }
    // A replay cannot be recorded, as it is a recording already.
    void perform_kind(view::SetRecording const&) { }
    // Devices cannot be watched, as none are connected.
    void perform_kind(view::WatchDevices const&) { }
    // There is no start page, as the window shows only this replay.
    void perform_kind(view::OpenStartPage const&) { }
    void perform_kind(view::OpenCalibration const&) { }
    void perform_kind(view::CloseCalibration const&) { }
    template<typename Command> void perform_kind(Command const& command)
    {
        controller_.perform(command, replay_.station());
    }

    view::StationView& view() { return controller_.view(); }

    drivers::Log const* log_;        // The log that is replayed. Not owned.
    station::ReplayOptions options_; // Options of the replay, kept so that it can start again.
    station::LogReplay replay_;
    Timestamp now_; // Current time of the replay, in the log's time.
    StationController controller_;
};

} // namespace tractus::controllers
