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
    // Calibrated rig; no value: the log's own rig or, failing that, a default of the tablet's size.
    std::optional<calib::Rig> rig {};
    std::optional<calib::HeightScenario> height {}; // Replaces the log's height sensor.
};

// Plays a log on a station of its own, in the file's order, as fast as requested. The same log
// gives the same strokes, bit for bit. The log must outlive the replay.
class LogReplay {
public:
    // Fails with a user error if the log has no pen, neither a height sensor nor a scenario, a
    // height sensor without a calibration, or a tool line with a known name and invalid arguments.
    static Result<LogReplay> create(drivers::Log const& log, ReplayOptions const& options);

    // Passes all strokes and other steps since the last call to a document, in their original
    // order.
    void replay_into(document::Document& document);

    // Sentences about lines of the log that this program does not understand, and what is left out
    // because of them.
    std::vector<std::string> const& left_out() const { return left_out_; }

    // Plays everything up to and including `time` of the log. Returns false when nothing is left;
    // Station::finish() has been called by then.
    bool advance_to(Timestamp time);

    // Like advance_to(), but stops at the end of the next stroke. Returns true while there is more
    // up to `time`.
    bool advance_to_stroke(Timestamp time);

    bool is_over() const { return finished_; }

    // Time of the next report, or the largest time stamp if none is left.
    Timestamp next_time();

    // Fails if the log could not be read to its end, which ends the replay.
    Result<void> const& outcome() const { return outcome_; }

    // Plays everything that is left into the document.
    void run(document::Document& document);

    Station const& station() const { return station_; }
    Station& station() { return station_; }
    Station take_station() && { return std::move(station_); }

    // Time of the first report; end() is that of the last. Equal for an empty log.
    Timestamp begin() const;
    Timestamp end() const;

private:
    // A line of the log about a tool or another step.
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
    std::size_t next_line_ = 0; // First line not reached yet.
    std::size_t next_step_ = 0; // First line that may be a step not handed over yet.
    std::size_t handed_strokes_ = 0;
    bool finished_ = false;
    Result<void> outcome_ {};
};

} // namespace tractus::station
