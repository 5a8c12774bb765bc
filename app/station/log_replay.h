#pragma once

#include "app/station/station.h"
#include "calib/height_scenario.h"
#include "calib/rig.h"
#include "drivers/log.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace tractus {

struct ReplayOptions {
    std::optional<Rig> rig;               // No value: the log's own, else one of the tablet's size.
    std::optional<HeightScenario> height; // In place of the log's height sensor.
    Scene scene;                          // What the strokes work on; its base plant is loaded.
};

// Feeds a log to a station of its own, in the file's order, as fast as it is asked to: the same log
// gives the same scene, bit for bit. The log must outlive the replay.
class LogReplay {
public:
    // Fails, as the user's fault, if the log has no pen, neither a height sensor nor a scenario, a
    // height sensor without a calibration, or a tool that does not exist.
    static Result<LogReplay> create(Log const& log, ReplayOptions options);

    // Everything up to and including `time` of the log. False when there is nothing left, and then
    // the station has finished.
    bool advance_to(Timestamp time);

    // The same, but no farther than to the end of the next stroke. True while there is more up to
    // `time`.
    bool advance_to_stroke(Timestamp time);

    bool is_over() const { return finished_; }

    // Fails if the log could not be read to its end, which ends the replay.
    Result<void> const& outcome() const { return outcome_; }

    // Everything that is left.
    void run() { advance_to(Timestamp::max()); }

    Station const& station() const { return station_; }
    Station& station() { return station_; }
    Station take_station() && { return std::move(station_); }

    // Of the first and the last report; equal for an empty log.
    Timestamp begin() const;
    Timestamp end() const;

private:
    LogReplay(Log const& log, Station station, std::vector<Tool> tools);

    void push_tools();

    Log const* log_; // Not owned.
    Station station_;
    std::vector<Tool> tools_; // One per tool line of the log.
    LogCursor cursor_;
    std::size_t next_tool_ = 0;
    bool finished_ = false;
    Result<void> outcome_ {};
};

} // namespace tractus
