#pragma once

#include "app/controllers/drawing_file.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Checks called by the scenarios. Each check prints its results and fails if they are wrong.
// Figures are printed as "figure: NAME = VALUE UNIT".

namespace tractus {

void print_figure(std::string const& name, double value, std::string const& unit);

// A gadget learns that it is read only when the host takes its first report, and repeats that
// report until then. Linux drops such repetitions; hidapi's libusb back end does not.
enum class FirstReport {
    Once,
    Repeated,
};

// Checks that the log `got_name` contains exactly the reports that the devices `sent_devices` of
// the log `sent_name` sent, in the same order. An empty list means all devices. Devices are matched
// by their report descriptors.
Result<void> compare_reports(std::string const& sent_name, std::string const& got_name,
                             std::vector<std::size_t> sent_devices, FirstReport first);

// Measures the regularity of the reports of one of the log's devices. Gaps of more than `pause_ms`
// are ignored, because the pen was away.
Result<void> measure_gaps(std::string const& log_name, std::size_t device, double pause_ms);

struct HeightExpectation {
    double fraction = 0;       // Expected mean of the samples, as a share of full scale.
    double tolerance = 0.0005; // Greatest deviation of any sample from the mean.
};

// Checks that the log's first height sensor measured the same height throughout.
Result<void> check_height(std::string const& log_name, HeightExpectation const& expected);

// Checks that the log's first height sensor measured the heights of another log. The two logs may
// have a constant offset in time, which the check determines. `tolerance` is the greatest error of
// any sample, as a share of full scale.
Result<void> compare_heights(std::string const& sent_name, std::string const& got_name,
                             double tolerance);

// Checks that an encoder measured the heights of the sent log. `counts` is its count at the full
// scale of that log's sensor. The two logs may have a constant offset in time. The count may lag by
// two while the encoder moves, since it can count no faster, and must be exact at the end.
Result<void> compare_encoder(std::string const& sent_name, std::string const& got_name,
                             unsigned counts);

struct StreamExpectation {
    std::uint64_t max_lost_frames = 0;
    std::uint64_t restarts = 0; // Number of times that the sensor was plugged in again.
};

// Checks that all frames of the station's own height sensor are complete and in order. Corrupt
// frames are never allowed.
Result<void> check_stream(std::string const& log_name, StreamExpectation const& expected);

struct TruthOptions {
    std::string script;      // Script of the simulated hand, one stroke for each gesture.
    std::string sent;        // Log sent by the simulated rig.
    std::string got;         // Recording of what was received, with the rig's calibration.
    std::string model;       // Plant with which the script was recorded.
    std::size_t strokes = 0; // Required number of strokes; 0: as many as the hand draws.
    bool is_torn = false;    // True: the recording may end before the sent log does.
    double limit_rms_mm = 1; // Limit of the root mean square distance from the hand.
    double limit_max_mm = 3; // Limit of the greatest distance from the hand.
    // Limit of the greatest distance from where the hand was within 20 ms, which excludes the
    // lateness of reports.
    double limit_path_mm = 3;
};

// Measures the distance of the station's strokes, made from a recording, from where the hand was.
// Fails if a distance exceeds its limit, or if the number of strokes is wrong.
Result<void> compare_strokes(TruthOptions const& options);

// Replays recordings one after the other into the session of a drawing, as the station's window
// does. The drawing may be new or continued.
Result<void> go_on_with_recordings(controllers::DrawingRequest const& drawing,
                                   std::vector<std::string> const& logs);

// Checks that two sessions have the same edits, except for the clocks of strokes.
Result<void> compare_drawings(std::string const& session, std::string const& other);

// Checks that the station made at least `least` strokes from a recording in which a device was
// disconnected at times, and that no stroke spans such a gap.
Result<void> check_interrupted_strokes(std::string const& log_name, std::string const& model,
                                       std::size_t least);

struct WatchedWindow {
    std::string model;        // Plant to draw on.
    std::string rig_file;     // Calibration of the devices.
    std::string session {};   // Session that stores the drawing and is continued; empty: none.
    std::string recording {}; // New log in which all input is recorded; empty: none.
    // Log whose tools are chosen one after the other, one for each stroke. Empty: the first tool is
    // kept.
    std::string tools {};
};

// Runs the station's live window without graphics on all devices that are found, until a signal
// stops it. Prints one line to standard output whenever the pen begins or ends to touch, a stroke
// is finished, or a device has a problem.
Result<void> watch_live_window(WatchedWindow const& watched);

// Reads a device with a thread that stores its reports, and fetches them only after `seconds`.
// Checks that all reports that were sent are then there, in order.
Result<void> read_late(std::string const& node, std::string const& sent_name, double seconds);

} // namespace tractus
