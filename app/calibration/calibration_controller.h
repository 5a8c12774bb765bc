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

// Procedures by which a person calibrates.
enum class CalibrationProcedure {
    Height,  // Meaning of the sensor's readings.
    Travel,  // How the surface moves aside while it rises.
    Latency, // How much later the pen arrives than the height.
    Tilt,    // How far beside its nib the tablet sees a pen that leans.
    Zero,    // Where height zero is; the scale stays.
    Check,   // Nothing: tells how exact the rig is.
};

std::string_view name_of(CalibrationProcedure procedure); // "height", "travel", …

// Whether a procedure consists of captures at rest; the others are one movement, from begin to end.
bool takes_captures(CalibrationProcedure procedure);

// Whether a procedure looks at the height sensor at all.
inline bool needs_height(CalibrationProcedure procedure)
{
    return procedure != CalibrationProcedure::Tilt;
}

// Result of a procedure.
struct CalibrationOutcome {
    calib::Rig rig {}; // The rig with what was found out, and its record.
    std::optional<calib::HeightFit> height_fit {}; // After Height.
    std::string report {}; // Text for the person; lines that end in a line break.
};

// A calibration under way: devices' reports and a person's commands in, a rig out. Live devices,
// simulated ones and a log go through it alike: it is told the time with everything, and a log of
// what it was told gives the same rig. Commands are words, as they stand behind "calibrate" in a
// log's tool lines:
//
//     capture 120.5    the surface is at 120.5 mm and rests; what the sensor sends from now on for
//                      kCaptureTime is the capture
//     undo             the last capture was wrong; or the one under way is given up
//     drop 3           the third capture was wrong
//     begin, end       of the movement of travel, latency and tilt; in a log without them it is all
//                      of it
//     cause slipped    why height zero is off: slipped or moved (zeroing.h)
//     press            the pen's touch under way presses a button: it is no rest, and no movement
class CalibrationController {
public:
    struct Options {
        CalibrationProcedure procedure = CalibrationProcedure::Height;
        calib::Rig rig {}; // The rig so far.
        calib::HeightFitOptions height {};
        std::optional<calib::ZeroCause>
            zero_cause {};      // No value: what the captures tell, or the usual.
        bool is_forced = false; // Whether a height fit is kept in spite of a doubt about it.
    };

    // Takes the first pen and the first height sensor. Fails, as the user's fault, if one that the
    // procedure needs is not there, and for a tilt if the tablet tells none.
    static Result<CalibrationController> create(std::span<drivers::DeviceInfo const> devices,
                                                Options options);

    // One report of one of the devices, in the order of their times. Broken ones are left out.
    void push(std::size_t device, Timestamp received, std::span<std::byte const> report);

    // Fails, as the user's fault, for words that mean nothing here, and for times that go back.
    Result<void> command(Timestamp time, std::string_view words);

    // Says what is wrong with the last capture: a sentence that says what to do. Empty if nothing
    // is.
    std::string const& refusal() const { return refusal_; }

    // Why the heights captured so far had better not be kept; no value if they may be, if there is
    // no fit yet, and after other procedures than Height.
    std::optional<calib::HeightFitDoubt> doubt() const;

    // Returns what the captures of Zero amount to, if it matters why heights are off and nothing
    // tells it yet; otherwise no value.
    std::optional<calib::Zeroing> open_question() const;

    bool is_capturing() const { return pending_.has_value(); }
    bool is_moving() const { return is_moving_; } // True between begin and end.

    CalibrationProcedure procedure() const { return options_.procedure; }
    calib::Rig const& rig() const { return options_.rig; }
    std::vector<calib::HeightCapture> const& captures() const { return captures_; }
    std::optional<calib::HeightReading> reading() const { return recent_.reading(); }
    calib::SensorIdentity const& sensor() const { return sensor_; } // The sensor of that reading.
    std::optional<drivers::PenSample> const& pen() const { return pen_; } // The last one.
    std::size_t touches() const { return touches_; } // Touches of the movement, so far.

    // True when the pen has touched for a while without moving, once for each touch: a person's
    // sign that the surface rests. The time is that of the data.
    bool take_pen_rest();

    // Returns what follows from everything so far. Fails as the procedure's fit does, if a capture
    // was refused and not made again, and for a doubt about the heights that is not forced. The
    // report names every capture that was refused, those that were made again, too.
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
    void close_capture();
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
    std::vector<drivers::HeightSample> new_heights_; // Kept for its memory.
    std::vector<drivers::PenSample> new_pens_;       // Likewise.
    std::optional<Pending> pending_;
    std::vector<calib::HeightCapture> captures_;
    std::optional<double> last_ruler_mm_; // Where the surface was last captured, dropped or not.
    std::string refusal_;
    std::vector<std::string> refusals_; // Kept for the report, all of them.
    std::optional<Timestamp> last_command_;

    std::optional<drivers::PenSample> pen_;
    std::optional<drivers::PenSample> touch_; // The present touch's first sample.
    bool is_rest_told_ = false;
    bool is_pressing_ = false; // The present touch is none of the calibration's.

    bool is_moving_ = true; // Always true in a log without begin and end.
    std::size_t touches_ = 0;
    std::vector<drivers::PenSample> pens_; // Pen samples of the movement.
    std::size_t pens_before_touch_ = 0;    // Number of pens_ before the present touch.
    std::vector<drivers::HeightSample> heights_;
};

} // namespace tractus::calibration
