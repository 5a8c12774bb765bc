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
    tools::Methods methods {};        // What the log may name.
    std::optional<calib::Rig> rig {}; // No value: the log's own, else one of the tablet's size.
    std::optional<calib::HeightScenario> height {}; // In place of the log's height sensor.
};

// Feeds a log to a station of its own, in the file's order, as fast as it is asked to: the same log
// gives the same strokes, bit for bit. The log must outlive the replay.
class LogReplay {
public:
    // Fails, as the user's fault, if the log has no pen, neither a height sensor nor a scenario, a
    // height sensor without a calibration, or a tool that does not exist.
    static Result<LogReplay> create(drivers::Log const& log, ReplayOptions const& options);

    // Gives what has been drawn, and what was done beside drawing, since the last call to a
    // document, in the order in which it was done when the log was made.
    void hand_over(document::Document& document);

    // Lines of the log that mean nothing to this program, and what is left out for it: a sentence
    // each.
    std::vector<std::string> const& left_out() const { return left_out_; }

    // Everything up to and including `time` of the log. False when there is nothing left, and then
    // the station has finished.
    bool advance_to(Timestamp time);

    // The same, but no farther than to the end of the next stroke. True while there is more up to
    // `time`.
    bool advance_to_stroke(Timestamp time);

    bool is_over() const { return finished_; }

    // Of the next report; the last moment that there is when none is left.
    Timestamp next_time();

    // Fails if the log could not be read to its end, which ends the replay.
    Result<void> const& outcome() const { return outcome_; }

    // Everything that is left, drawn in the document.
    void run(document::Document& document);

    Station const& station() const { return station_; }
    Station& station() { return station_; }
    Station take_station() && { return std::move(station_); }

    // Of the first and the last report; equal for an empty log.
    Timestamp begin() const;
    Timestamp end() const;

private:
    // A line of the log about tools, or what was done beside drawing.
    struct Line {
        std::size_t position = 0; // See LogTool.
        Timestamp time {};
        std::variant<tools::Tool, document::LoggedStep, tools::LeastExtents> what;
    };

    LogReplay(drivers::Log const& log, Station station, std::vector<Line> lines,
              std::vector<std::string> left_out);

    static Result<std::vector<Line>> read_lines(drivers::Log const& log,
                                                tools::Methods const& methods,
                                                std::vector<std::string>& left_out);
    void push_lines();

    drivers::Log const* log_; // Not owned.
    Station station_;
    std::vector<Line> lines_;
    std::vector<std::string> left_out_;
    drivers::LogCursor cursor_;
    std::size_t next_line_ = 0; // Not reached yet.
    std::size_t next_step_ = 0; // The next line that may be a step to be handed over.
    std::size_t handed_strokes_ = 0;
    bool finished_ = false;
    Result<void> outcome_ {};
};

} // namespace tractus::station
