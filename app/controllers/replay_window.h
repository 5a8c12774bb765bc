#pragma once

#include "app/controllers/station_controller.h"
#include "app/station/log_replay.h"
#include "app/view/window_model.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <optional>

namespace tractus::controllers {

// Contents of the station's window while a log is replayed at the pace of the hand that drew it:
// the hand, its strokes, what is selected, and the plant, which is grown anew after each stroke.
class ReplayWindow final : public view::WindowModel {
public:
    // The log must outlive the window. `pictures` is the folder in which saved pictures appear. A
    // session keeps what is drawn, on its scene in place of `scene`. Fails like
    // LogReplay::create.
    static Result<ReplayWindow> create(drivers::Log const& log, station::ReplayOptions options,
                                       scene::Scene scene, std::filesystem::path pictures,
                                       std::optional<session::Session> session = {});

    ReplayWindow(ReplayWindow&&) = default;
    ReplayWindow& operator=(ReplayWindow&&) = delete;
    ~ReplayWindow() override; // Closes, if that was not done.

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
    void perform_kind(view::ChooseTool const&) { } // The recording chooses.
    void perform_kind(view::AdjustTool const&) { }
    void perform_kind(view::TakeLikeDrawn const&) { }
    void perform_kind(view::KeepCard const&) { }
    void perform_kind(view::RenameCard const&) { }
    void perform_kind(view::RemoveCard const&) { }
    void perform_kind(view::OpenPictures const&) { }
    void perform_kind(view::LayPictureFile const&) { }
    void perform_kind(view::DragDrawnGlyph const&) { }
    void perform_kind(view::OpenLeaves const&) { }
    void perform_kind(view::DressActivePlant const&) { }
    void perform_kind(view::BringLeaf const&) { }
    void perform_kind(view::NameDrawing const&) { } // It is a recording's.
    void perform_kind(view::SaveCopy const&) { }
    void perform_kind(view::WriteRules const&) { }
    void perform_kind(view::SetPressingAreas const&) { } // The hand was elsewhere.
    void perform_kind(view::PressInstead const&) { }
    void perform_kind(view::MoveMousePen const&) { }
    void perform_kind(view::MoveSurface const&) { }
    void perform_kind(view::SetRecording const&) { }  // It is recorded.
    void perform_kind(view::WatchDevices const&) { }  // None is read.
    void perform_kind(view::OpenStartPage const&) { } // It has an end of its own.
    void perform_kind(view::OpenCalibration const&) { }
    void perform_kind(view::CloseCalibration const&) { }
    template<typename Command> void perform_kind(Command const& command)
    {
        controller_.perform(command, replay_.station());
    }

    view::StationView& view() { return controller_.view(); }

    drivers::Log const* log_;        // Not owned.
    station::ReplayOptions options_; // To begin again.
    station::LogReplay replay_;
    Timestamp now_; // Time of the log.
    StationController controller_;
};

} // namespace tractus::controllers
