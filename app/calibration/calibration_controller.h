#pragma once

#include "calib/calibrate.h"
#include "calib/height_capture.h"
#include "calib/height_fit_doubt.h"
#include "calib/rig.h"
#include "calib/zeroing.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::calibration {

// Calibration procedures.
enum class CalibrationProcedure {
    Height,  // Determines how the sensor's readings convert to heights.
    Travel,  // Determines how the surface moves sideways while it rises.
    Latency, // Determines the delay of the pen's samples relative to the height's.
    // Determines the offset between the nib and the position that the tablet reports for a tilted
    // pen.
    Tilt,
    Zero,  // Determines the position of height zero again; the scale stays.
    Check, // Determines nothing, but reports the rig's accuracy.
};

// Returns "height", "travel", and so on, as on the command line.
std::string_view name_of(CalibrationProcedure procedure);

// True if a procedure consists of captures at rest. All other procedures consist of one movement.
bool takes_captures(CalibrationProcedure procedure);

// True if a procedure uses the height sensor.
inline bool needs_height(CalibrationProcedure procedure)
{
    return procedure != CalibrationProcedure::Tilt;
}

// Result of a procedure.
struct CalibrationOutcome {
    calib::Rig rig {}; // The rig with the new results and a record of the calibration.
    // Fit of the heights; only after the procedure Height.
    std::optional<calib::HeightFit> height_fit {};
    std::string report {}; // Text for the user; each line ends in a line break.
};

// A calibration in progress. It receives device reports and the user's commands, and computes a
// rig. All input carries its time, so it makes no difference whether it comes from live devices,
// simulated devices or a log, and a log of the input gives the same rig. Commands are texts, as
// they follow the word "calibrate" in a log's tool lines:
//
//     capture 120.5    the surface rests at 120.5 mm; sensor readings of the next kCaptureTime are
//                      the capture
//     undo             deletes the last capture, or cancels the one in progress
//     drop 3           deletes the third capture
//     begin, end       start and end of the movement of travel, latency and tilt; a log without
//                      them is one movement
//     cause slipped    why height zero is off: slipped or moved (zeroing.h)
//     press            the current touch of the pen presses a button: it is neither a rest nor a
//                      movement
class CalibrationController {
public:
    struct Options {
        CalibrationProcedure procedure = CalibrationProcedure::Height;
        calib::Rig rig {}; // The rig from which the calibration starts.
        calib::HeightFitOptions height {};
        // Cause of the error of height zero. No value: it is inferred from the captures if
        // possible, otherwise the string is assumed to have slipped.
        std::optional<calib::ZeroCause> zero_cause {};
        // True: a height fit is accepted in spite of a doubt (HeightFitDoubt) about it.
        bool is_forced = false;
    };

    // Uses the first pen and the first height sensor of `devices`. Fails with a user error if one
    // that the procedure needs is missing, and for Tilt if the tablet does not report tilt.
    static Result<CalibrationController> create(std::span<drivers::DeviceInfo const> devices,
                                                Options options);

    // Processes one report of a device; reports must come in order of time. Invalid reports are
    // ignored. An empty report means that the device was disconnected; if it is the height sensor,
    // a capture in progress is refused.
    void push(std::size_t device, Timestamp received, std::span<std::byte const> report);

    // Processes a command. Fails with a user error for unknown words, and for times that go
    // backwards.
    Result<void> command(Timestamp time, std::string_view words);

    // Says what was wrong with the last capture, and what to do about it; empty if nothing was
    // wrong, and after "undo".
    std::string const& refusal() const { return refusal_; }

    // A reason to distrust the heights captured so far. No value if there is none, if there is no
    // fit yet, or if the procedure is not Height.
    std::optional<calib::HeightFitDoubt> doubt() const;

    // The provisional result of Zero, while it depends on a cause of the error that is not yet
    // known; otherwise no value.
    std::optional<calib::Zeroing> open_question() const;

    bool is_capturing() const { return pending_.has_value(); }
    // True between the commands "begin" and "end" of a movement.
    bool is_moving() const { return is_moving_; }

    CalibrationProcedure procedure() const { return options_.procedure; }
    calib::Rig const& rig() const { return options_.rig; }
    std::vector<calib::HeightCapture> const& captures() const { return captures_; }
    std::optional<calib::HeightReading> reading() const { return recent_.reading(); }
    // Identity of the height sensor that gives reading().
    calib::SensorIdentity const& sensor() const { return sensor_; }
    std::optional<drivers::PenSample> const& pen() const { return pen_; } // Latest pen sample.
    // Number of pen samples in the movement so far that touch the tablet.
    std::size_t touches() const { return touches_; }

    // True, once per touch, when the pen has touched the tablet for a while without moving, by
    // which the user shows that the surface rests. Measured in the time of the reports.
    bool take_pen_rest();

    // Computes the result of all input so far. Fails like the procedure's fit, if a refused capture
    // was not repeated, and if there is a doubt about the heights and `is_forced` is not set. The
    // report lists every refused capture, including those that were repeated.
    Result<CalibrationOutcome> finish(std::string const& date) const;

private:
    struct Pending {
        double ruler_mm = 0;
        Timestamp begin {};
        std::vector<drivers::HeightSample> samples {};
    };

    explicit CalibrationController(Options options)
        : options_(std::move(options))
    {
    }

    void push_pen(drivers::PenSample const& sample);
    void push_height(drivers::HeightSample const& sample);
    void refuse_capture(std::string_view reason);
    void close_capture(Timestamp now);
    Result<void> capture(Timestamp time, std::string_view height);
    Result<void> drop(std::string_view number);
    void undo();
    void begin_movement();
    void press();
    Result<CalibrationOutcome> conclude(std::string const& date) const;
    Result<CalibrationOutcome> finish_height(std::string const& date) const;
    Result<CalibrationOutcome> finish_travel(std::string const& date) const;
    Result<CalibrationOutcome> finish_latency(std::string const& date) const;
    Result<CalibrationOutcome> finish_tilt(std::string const& date) const;
    Result<CalibrationOutcome> finish_zero() const;
    Result<CalibrationOutcome> finish_check(std::string const& date) const;

    Options options_;
    std::unique_ptr<drivers::PenDecoder> pen_decoder_;
    std::size_t pen_device_ = 0;
    std::unique_ptr<drivers::HeightDecoder> height_decoder_;
    std::size_t height_device_ = 0;
    calib::SensorIdentity sensor_;

    calib::RecentReadings recent_;
    // Height samples of the current report. A member, so that its memory is reused.
    std::vector<drivers::HeightSample> new_heights_;
    // Pen samples of the current report. A member, so that its memory is reused.
    std::vector<drivers::PenSample> new_pens_;
    std::optional<Pending> pending_;
    std::vector<calib::HeightCapture> captures_;
    // Height of the last capture by time, even if that capture was dropped.
    std::optional<double> last_ruler_mm_;
    std::string refusal_;
    std::vector<std::string> refusals_; // All refusals so far, for the final report.
    std::optional<Timestamp> last_command_;

    std::optional<drivers::PenSample> pen_;
    std::optional<drivers::PenSample> touch_; // First sample of the current touch.
    bool is_rest_reported_ = false;
    bool is_pressing_ = false; // True if the current touch does not belong to the calibration.

    // True during a movement. In a log without "begin" and "end", always true.
    bool is_moving_ = true;
    std::size_t touches_ = 0;
    std::vector<drivers::PenSample> pens_; // Pen samples received during the movement.
    std::size_t pens_before_touch_ = 0; // Number of samples in pens_ from before the current touch.
    std::vector<drivers::HeightSample> heights_;
};

} // namespace tractus::calibration
