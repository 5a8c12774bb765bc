#pragma once

#include "app/controllers/drawing_file.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Checks called by the scenarios. Each check prints its results, figures as "figure: NAME = VALUE
// UNIT", and fails if they are wrong.

namespace tractus {

void print_figure(std::string const& name, double value, std::string const& unit);

// A gadget learns that it is read only when its first report is taken, and repeats that report
// until then. Linux drops such repetitions, hidapi's libusb back end does not.
enum class FirstReport {
    Once,
    Repeated,
};

// Checks that `got` contains exactly the reports of these devices of `sent`, or of all, in the same
// order. Devices are matched by their report descriptors.
Result<void> compare_reports(std::string const& sent_name, std::string const& got_name,
                             std::vector<std::size_t> sent_devices, FirstReport first);

// Measures the regularity of the reports of one of the log's devices. Gaps of more than `pause_ms`
// are ignored, since the pen was away.
Result<void> measure_gaps(std::string const& log_name, std::size_t device, double pause_ms);

struct HeightExpectation {
    double fraction = 0;       // Expected mean of the samples, as a share of full scale.
    double tolerance = 0.0005; // Greatest deviation of any sample from the mean.
};

// Checks that the log's first height sensor measured the same height throughout.
Result<void> check_height(std::string const& log_name, HeightExpectation const& expected);

// Checks that the log's first height sensor measured the heights of another log, with a constant
// time offset, which is determined. `tolerance` is a share of full scale for every sample.
Result<void> compare_heights(std::string const& sent_name, std::string const& got_name,
                             double tolerance);

// Checks that an encoder, which counts `counts` over the full scale of the sent log's sensor,
// measured its heights with a constant time offset: within two counts while moving, since it may
// count no faster, and exactly at the end.
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

// Measures how far the strokes that the station makes from a recording are from where the hand was.
// Fails above the limits, or if the number of strokes is wrong.
Result<void> compare_strokes(TruthOptions const& options);

// Replays recordings, one after the other, into the session of a drawing, new or continued, as the
// station's window does.
Result<void> go_on_with_recordings(controllers::DrawingRequest const& drawing,
                                   std::vector<std::string> const& logs);

// Checks that two sessions have the same edits, except for the clocks of strokes.
Result<void> compare_drawings(std::string const& session, std::string const& other);

// Checks that the station made at least `least` strokes from a recording in which a device was
// sometimes away, and that no stroke spans such a gap.
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

// Reads a device on a thread of its own while its reports are not fetched for `seconds`. Checks
// that all reports that were sent are there afterwards, in order.
Result<void> read_late(std::string const& node, std::string const& sent_name, double seconds);

} // namespace tractus
