#pragma once

#include "app/controllers/drawing_file.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Checks that the scenarios call. Each check prints what it finds, figures as "figure: NAME = VALUE
// UNIT", and fails if it is not as it should be.

namespace tractus {

void print_figure(std::string const& name, double value, std::string const& unit);

// A gadget learns that it is read from its first report's being taken, and repeats it until then.
// Linux lets no such repetition through, hidapi's libusb back end does.
enum class FirstReport {
    Once,
    Repeated,
};

// Whether every report of these devices of `sent`, or of all, is in `got`, and nothing else, in the
// same order. A device of `got` is the same one if its report descriptor is.
Result<void> compare_reports(std::string const& sent_name, std::string const& got_name,
                             std::vector<std::size_t> sent_devices, FirstReport first);

// How regularly the reports of one of the log's devices came. Gaps of more than `pause_ms` are left
// out: the pen was away.
Result<void> measure_gaps(std::string const& log_name, std::size_t device, double pause_ms);

struct HeightExpectation {
    double fraction = 0;       // Share of full scale, in the mean …
    double tolerance = 0.0005; // … of all samples, so far off at most.
};

// Whether the log's first height sensor always said the same.
Result<void> check_height(std::string const& log_name, HeightExpectation const& expected);

// Whether the log's first height sensor saw the heights of another log, at one and the same
// distance in time throughout, which is found out. `tolerance` is of full scale, anywhere.
Result<void> compare_heights(std::string const& sent_name, std::string const& got_name,
                             double tolerance);

// Whether an encoder that counts `counts` over the full scale of the sent log's sensor saw its
// heights, at one and the same distance in time: within two counts on the way, as it may count no
// quicker, and to the count at the end.
Result<void> compare_encoder(std::string const& sent_name, std::string const& got_name,
                             unsigned counts);

struct StreamExpectation {
    std::uint64_t max_lost_frames = 0;
    std::uint64_t restarts = 0; // How often the sensor was plugged in again.
};

// Whether the frames of the station's own height sensor came whole and in order. Broken ones never
// may.
Result<void> check_stream(std::string const& log_name, StreamExpectation const& expected);

struct TruthOptions {
    std::string script;      // The script of the simulated hand, one stroke to a gesture.
    std::string sent;        // The log that the simulated rig sent.
    std::string got;         // The recording of it, with the rig's calibration.
    std::string model;       // The plant that the script was recorded with.
    std::size_t strokes = 0; // How many there must be; 0: as the hand draws.
    bool is_torn = false;    // The recording may end before what was sent does.
    double limit_rms_mm = 1; // Root mean square of the distances,
    double limit_max_mm = 3; // and the largest one,
    // and the largest one from where the hand was within 20 ms: how late reports come is left out.
    double limit_path_mm = 3;
};

// How far the strokes that the station makes of a recording lie from where the hand was. Fails
// above the limits, or if there are not so many strokes.
Result<void> compare_strokes(TruthOptions const& options);

// Replays recordings, one after the other, into the session of a drawing, as the station's window
// does: a new one, or one that is gone on with.
Result<void> go_on_with_recordings(controllers::WantedDrawing const& drawing,
                                   std::vector<std::string> const& logs);

// Whether two sessions have the same edits, but for the clock of each stroke.
Result<void> compare_drawings(std::string const& session, std::string const& other);

// Whether the station made strokes of a recording in which a device was away from time to time,
// each of them without such a gap, and at least so many.
Result<void> check_interrupted_strokes(std::string const& log_name, std::string const& model,
                                       std::size_t least);

struct WatchedWindow {
    std::string model;        // A plant to draw on.
    std::string rig_file;     // The calibration of the devices.
    std::string session {};   // Keeps what is drawn, and is gone on with; empty: none.
    std::string recording {}; // The new log of all that comes; empty: none.
    // A log whose tool lines are chosen one after the other, one for each stroke. Empty: the first
    // tool stays in the hand.
    std::string tools {};
};

// The station's live window but for its pixels, on all devices that are found, until a signal asks
// to stop. Says on standard output, a line each, when the pen begins and ends to touch, a stroke is
// finished, and what is wrong with the devices.
Result<void> watch_live_window(WatchedWindow const& watched);

// Reads a device on a thread of its own, with nobody taking what was read for `seconds`; then what
// came must begin with what was sent, and be all of it.
Result<void> read_late(std::string const& node, std::string const& sent_name, double seconds);

} // namespace tractus
