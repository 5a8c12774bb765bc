#pragma once

#include "app/live_devices.h"
#include "app/live_recorder.h"
#include "app/session/session.h"
#include "app/station_view.h"
#include "app/window/window_model.h"
#include "calib/rig.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

struct LiveWindowOptions {
    std::optional<Rig> rig {}; // No value: that of a log among the devices, else see create().
    // The surface's height in place of a height sensor, above the desk.
    std::optional<double> height_mm {};
    Scene scene {};                       // What the pen works on; its base plant is loaded.
    std::filesystem::path pictures = "."; // The folder in which saved pictures appear.
    std::filesystem::path recording {};   // The new log of all that comes; empty: none.
    // Keeps what is drawn; the pen works on its scene in place of the one above.
    std::optional<Session> session {};
    std::function<Timestamp()> now {}; // The clock of the reports.
};

// What the station's window shows while somebody draws: devices are read on threads of their own,
// and each advance() takes what they have sent. Devices may go away and come back meanwhile.
class LiveWindow final : public WindowModel {
public:
    // Fails like Station::create and LiveRecorder::create; and, as the user's fault, if there is a
    // height sensor but neither a calibration of it nor a height. Without a height sensor and a
    // height the surface lies on the desk.
    static Result<LiveWindow> create(LiveDevices devices, LiveWindowOptions options);

    void advance(Duration real_step) override;
    WindowState const& state() const override { return view_.state(); }
    void perform(WindowCommand const& command) override;

    Station const& station() const { return station_; }

private:
    LiveWindow(LiveDevices devices, LiveWindowOptions options, StationOptions station_options,
               Station station);

    void perform_kind(SetPlaying const&) { } // A hand has no pause,
    void perform_kind(SetSpeed const&) { }   // nor another speed.
    void perform_kind(Restart const&);
    void perform_kind(NextVariation const&);
    void perform_kind(SavePicture const& command);
    void perform_kind(ChooseTool const& command);
    void perform_kind(Undo const&);
    void perform_kind(Redo const&);

    void take_reports();
    void keep_strokes();
    void tell_what_is_not_kept();
    void restart_session();
    void show_session(Result<void> const& done, std::string const& status);
    void tell_device_changes();
    void tell_who_is_away();
    void stop_recording(std::string const& why);

    LiveDevices devices_;
    LiveWindowOptions options_;
    StationOptions station_options_; // To begin again.
    Station station_;
    StationView view_;
    std::optional<LiveRecorder> recorder_;
    std::size_t kept_strokes_ = 0;           // Of the station's: they are in the session.
    std::string not_kept_;                   // Why the next one is not; empty if it is.
    Timestamp next_try_ {};                  // To keep it.
    std::vector<LiveReport> reports_;        // Kept for its memory.
    std::vector<LiveDevices::State> states_; // As the person was told.
};

} // namespace tractus
