#pragma once

#include "app/calibration/calibration_controller.h"
#include "app/devices/live_devices.h"
#include "app/devices/live_recorder.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::calibration {

// The user at a terminal, or a script that supplies the same input. Each character is a command:
//
//     digits, point, minus   a height; backspace deletes a character
//     Enter                  captures at that height, or starts and ends the movement
//     u                      deletes the last capture, or cancels the one in progress
//     f                      finishes with a fit, after repeating captures that disagree
//     s, m                   answers that the string slipped or the table moved, when asked
//     q                      quits at any time without changes
struct CalibrationPerson {
    // Returns the next character, or no value if none is waiting. '\4' is the end of input.
    std::function<std::optional<char>()> key;
    std::function<void(std::string const&)> say;  // Prints a line; the text has no line break.
    std::function<void(std::string const&)> show; // Replaces the status line at the bottom.
    // True for a script. Nobody is there to try again, so a refused capture ends the calibration.
    bool is_script = false;
};

struct LiveCalibrationOptions {
    // Heights to capture, in this order. Empty: the user types each height.
    std::vector<double> heights_mm {};
    bool is_forced = false; // True: captures that disagree need not be repeated.
    // Recorder of the calibration, not owned; null: no recording.
    devices::LiveRecorder* recorder = nullptr;
    Timestamp start {}; // Start of the recording.
    std::function<Timestamp()> now {};
    std::function<void(Duration)> rest {};
};

// Runs a calibration with live devices and a user to its end. A height is captured when the user
// presses Enter or rests the pen on the tablet. The controller receives the same times as a log
// would contain, so that a recording gives the same rig. After the end of keyboard input, resting
// the pen captures the remaining heights, and a movement lasts until the devices end. Returns true
// when complete, false if the user quit or `stop` was set. Fails if the devices end too early, if
// the recording cannot be written, and, with a script, if a capture is refused or the sensor stops
// sending during one.
Result<bool> calibrate_live(CalibrationController& controller, devices::LiveDevices& devices,
                            CalibrationPerson const& person, LiveCalibrationOptions const& options,
                            std::atomic<bool> const& stop);

// Describes the sensor's reading in one line: "2034 counts (49.7 %), noise 1.0, at rest, 123.4 mm".
// For a procedure without heights, describes the pen's tilt: "leans 23 degrees right, 5 away".
std::string describe_reading(CalibrationController const& controller);

// Instructions for the user before and during the movement of a calibration procedure, as sentences
// without a full stop.
struct MovementInstructions {
    std::string_view before;
    std::string_view during;
};
MovementInstructions movement_words(CalibrationProcedure procedure);

} // namespace tractus::calibration
