#pragma once

#include "app/calibration/calibration_desk.h"
#include "app/live_devices.h"
#include "app/window/calibration_view.h"
#include "app/window/window_model.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <functional>
#include <string>
#include <vector>

namespace tractus {

struct CalibrationWindowOptions {
    CalibrationDesk::Options desk {};
    std::vector<double> heights_mm {}; // To propose, in this order; empty: those of the procedure.
    std::string date {};               // Today's.
    std::function<Timestamp()> now {};

    // Writes what was found out; what it did, or why it could not.
    std::function<Result<std::string>(CalibrationOutcome const&)> keep {};
};

// What the window shows while a person calibrates with live devices: the reading, the captures and,
// from the second one on, the fit and its plots. A pen that rests on the tablet captures the
// proposed height. What one procedure found out is what the next begins with; nothing is written
// before the person asks for it.
class CalibrationWindow final : public WindowModel, private CalibrationModel {
public:
    // Fails as CalibrationDesk::create does.
    static Result<CalibrationWindow> create(LiveDevices devices, CalibrationWindowOptions options);

    void advance(Duration real_step) override;
    WindowState const& state() const override { return state_; }
    void perform(WindowCommand const&) override { }
    CalibrationModel* calibration() override { return this; }

private:
    CalibrationWindow(LiveDevices devices, CalibrationWindowOptions options, CalibrationDesk desk);

    CalibrationView const& view() const override { return view_; }
    void perform(CalibrationCommand const& command) override;
    void perform_kind(ChooseProcedure const& command);
    void perform_kind(CaptureAt const& command);
    void perform_kind(UndoCapture const&);
    void perform_kind(BeginMovement const&);
    void perform_kind(EndMovement const&);
    void perform_kind(KeepRig const&);

    void capture(Timestamp time, double ruler_mm);
    bool command(Timestamp time,
                 std::string const& words); // False if it was refused; the view says why.
    void fit();
    void propose();
    void show_reading();
    void refuse(std::string const& why);

    LiveDevices devices_;
    CalibrationWindowOptions options_;
    CalibrationDesk desk_;
    std::vector<LiveReport> reports_;
    std::optional<CalibrationOutcome> outcome_; // Of everything so far.
    bool was_capturing_ = false;
    bool is_moving_ = false;
    CalibrationView view_;
    WindowState state_; // Nothing but the calibration is shown.
};

} // namespace tractus
