#pragma once

#include "app/controllers/station_controller.h"
#include "app/station/log_replay.h"
#include "app/view/window_model.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <optional>

namespace tractus {

// Contents of the station's window while a log is replayed at the pace of the hand that drew it:
// the hand, its strokes, what is selected, and the plant, which is grown anew after each stroke.
class ReplayWindow final : public WindowModel {
public:
    // The log must outlive the window. `pictures` is the folder in which saved pictures appear. A
    // session keeps what is drawn, on its scene in place of `scene`. Fails like
    // LogReplay::create.
    static Result<ReplayWindow> create(drivers::Log const& log, ReplayOptions options, Scene scene,
                                       std::filesystem::path pictures,
                                       std::optional<Session> session = {});

    ReplayWindow(ReplayWindow&&) = default;
    ReplayWindow& operator=(ReplayWindow&&) = delete;
    ~ReplayWindow() override; // Closes, if that was not done.

    void advance(Duration real_step) override;
    void settle() override { controller_.settle(replay_.station(), now_); }
    bool may_close() override { return controller_.may_close(finish()); }
    Result<void> close() override;
    WindowState const& state() const override { return controller_.view().state(); }
    void perform(WindowCommand const& command) override;

private:
    Result<void> finish();
    ReplayWindow(drivers::Log const& log, ReplayOptions options, LogReplay replay,
                 StationController controller);

    void perform_kind(SetPlaying const& command);
    void perform_kind(SetSpeed const& command);
    void perform_kind(Restart const&);
    void perform_kind(ChooseTool const&) { } // The recording chooses.
    void perform_kind(AdjustTool const&) { }
    void perform_kind(TakeLikeDrawn const&) { }
    void perform_kind(KeepCard const&) { }
    void perform_kind(RenameCard const&) { }
    void perform_kind(RemoveCard const&) { }
    void perform_kind(OpenPictures const&) { }
    void perform_kind(LayPictureFile const&) { }
    void perform_kind(DragDrawnGlyph const&) { }
    void perform_kind(OpenLeaves const&) { }
    void perform_kind(DressActivePlant const&) { }
    void perform_kind(NameDrawing const&) { } // It is a recording's.
    void perform_kind(SaveCopy const&) { }
    void perform_kind(SetPressingAreas const&) { } // The hand was elsewhere.
    void perform_kind(PressInstead const&) { }
    void perform_kind(MoveMousePen const&) { }
    void perform_kind(MoveSurface const&) { }
    void perform_kind(SetRecording const&) { }  // It is recorded.
    void perform_kind(WatchDevices const&) { }  // None is read.
    void perform_kind(OpenStartPage const&) { } // It has an end of its own.
    void perform_kind(OpenCalibration const&) { }
    void perform_kind(CloseCalibration const&) { }
    template<typename Command> void perform_kind(Command const& command)
    {
        controller_.perform(command, replay_.station());
    }

    StationView& view() { return controller_.view(); }

    drivers::Log const* log_; // Not owned.
    ReplayOptions options_;   // To begin again.
    LogReplay replay_;
    Timestamp now_; // Time of the log.
    StationController controller_;
};

} // namespace tractus
