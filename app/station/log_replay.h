#pragma once

#include "app/document/document.h"
#include "app/station/station.h"
#include "app/tools/methods.h"
#include "calib/height_scenario.h"
#include "calib/rig.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tractus::station {

struct ReplayOptions {
    tools::Methods methods {}; // Tools and edits that the log may contain.
    // Calibrated rig. No value: the rig in the log or, if there is none, a default rig of the
    // tablet's size.
    std::optional<calib::Rig> rig {};
    // Scenario whose heights replace those of the log's height sensor.
    std::optional<calib::HeightScenario> height {};
};

// Plays a log on its own station, in the file's order, as fast as the caller requests. The same log
// gives the same strokes, bit for bit. The log must outlive the replay.
class LogReplay {
public:
    // Fails with a user error if the log has no pen, has neither a height sensor nor a scenario,
    // has a height sensor without a calibration, or has a tool line with a known name and invalid
    // arguments.
    static Result<LogReplay> create(drivers::Log const& log, ReplayOptions const& options);

    // Passes all strokes and other steps played since the last call to a document, in their
    // original order.
    void replay_into(document::Document& document);

    // Sentences for the user about lines of the log that this program does not understand, and
    // about the strokes that it leaves out because of these.
    std::vector<std::string> const& left_out() const { return left_out_; }

    // Plays all of the log up to and including `time`. Returns false when nothing of the log is
    // left; Station::finish() has been called by then.
    bool advance_to(Timestamp time);

    // Like advance_to(), but stops at the end of the next stroke. Returns true if it has stopped
    // there; more of the log may follow up to `time`.
    bool advance_to_stroke(Timestamp time);

    bool is_over() const { return finished_; }

    // Time of the log's next report, or the largest time stamp if none is left.
    Timestamp next_time();

    // Fails if the log could not be read to its end, which ends the replay.
    Result<void> const& outcome() const { return outcome_; }

    // Plays the rest of the log into the document.
    void run(document::Document& document);

    Station const& station() const { return station_; }
    Station& station() { return station_; }
    Station take_station() && { return std::move(station_); }

    // Time of the log's first report; end() is that of the last. Both are equal for an empty log.
    Timestamp begin() const;
    Timestamp end() const;

private:
    // A line of the log that selects a tool, sets minimum extents or is a step.
    struct Line {
        std::size_t position = 0; // Position of the line in the log; see LogTool.
        Timestamp time {};
        std::variant<tools::Tool, document::LoggedStep, tools::MinExtents> what;
    };

    LogReplay(drivers::Log const& log, Station station, std::vector<Line> lines,
              std::vector<std::string> left_out);

    static Result<std::vector<Line>> read_lines(drivers::Log const& log,
                                                tools::Methods const& methods,
                                                std::vector<std::string>& left_out);
    void push_lines();

    drivers::Log const* log_; // The log that is played; not owned.
    Station station_;
    std::vector<Line> lines_;
    std::vector<std::string> left_out_;
    drivers::LogCursor cursor_;
    std::size_t next_line_ = 0; // Index in lines_ of the first line not reached yet.
    std::size_t next_step_ = 0; // Index in lines_; all steps before it have been handed over.
    std::size_t handed_strokes_ = 0;
    bool finished_ = false;
    Result<void> outcome_ {};
};

} // namespace tractus::station
