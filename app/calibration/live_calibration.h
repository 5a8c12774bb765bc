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

// A person at a terminal, or a script that writes to standard input in one's place. Characters:
//
//     digits, point, minus   a height; backspace takes one back
//     Enter                  captures there, or begins and ends the movement
//     u                      the last capture was wrong, or the one under way is given up
//     f                      done: fit; captures that disagree are to be measured again first
//     s, m                   the string slipped, or the table moved, when that is asked
//     q                      away at any time, and nothing is changed
struct CalibrationPerson {
    std::function<std::optional<char>()> key;     // No value: none now. '\4' is the input's end.
    std::function<void(std::string const&)> say;  // A line, without its break.
    std::function<void(std::string const&)> show; // Shows what the line under all others says now.
    bool is_script = false; // Nobody is there to try again: what is refused is a failure.
};

struct LiveCalibrationOptions {
    std::vector<double> heights_mm {}; // To be captured in this order; empty: the person says them.
    bool is_forced = false;            // Captures that disagree are no reason to go on.
    devices::LiveRecorder* recorder = nullptr; // Not owned; null: nothing is recorded.
    Timestamp start {};                        // Start of the recording.
    std::function<Timestamp()> now {};
    std::function<void(Duration)> rest {};
};

// Lets a person calibrate with live devices until the end: heights are captured at Enter, or when
// the pen has rested on the tablet. The controller sees times as a log has them, so that the
// recording gives the same rig. At the input's end nobody is there any more: the pen's rests
// capture the heights that are left, and a movement is all that comes until the devices end. True
// when all was done, false when the person went away or `stop` was set. Fails if the devices end
// before, if the recording cannot be written, and, with a script, if a capture is refused or the
// sensor falls silent during one.
Result<bool> calibrate_live(CalibrationController& controller, devices::LiveDevices& devices,
                            CalibrationPerson const& person, LiveCalibrationOptions const& options,
                            std::atomic<bool> const& stop);

// Describes the reading in one line for the screen: "2034 counts (49.7 %), noise 1.0, at rest,
// 123.4 mm". Of a procedure without heights, how the pen leans: "leans 23 degrees right, 5 away".
std::string describe_reading(CalibrationController const& controller);

// What a person does before and during the movement of a procedure that takes no captures, as
// sentences without their end.
struct MovementWords {
    std::string_view before;
    std::string_view during;
};
MovementWords movement_words(CalibrationProcedure procedure);

} // namespace tractus::calibration
