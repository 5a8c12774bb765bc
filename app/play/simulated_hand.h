#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>
#include <vector>

namespace tractus::play {

// A simulated rig whose hand draws a recording. Its devices send the recorded reports, and the
// log's tool lines select the tools. The recording starts with begin(). Before and after the
// recording the pen is away; a height sensor keeps sending its resting value, so that it is not
// diagnosed as broken. Use the hand and its sources from one thread; the sources never wait. The
// output is deterministic for equal calls at equal times.
class SimulatedHand {
public:
    // `now` is the clock that gives reports their time. The log must be completely in memory.
    SimulatedHand(std::shared_ptr<drivers::Log const> log, std::function<Timestamp()> now);

    // Returns one source for each device of the recording, in the recording's order.
    std::vector<std::unique_ptr<drivers::ReportSource>> open_sources() const;

    // Starts the recording, unless it has already started.
    void begin();

    // True once the whole recording has been due.
    bool is_over() const;

    // Returns the tool lines that have become due since the last call, with times of the clock
    // `now`.
    std::vector<drivers::LogTool> take_tools();

    struct Shared; // State shared with the sources.

private:
    std::shared_ptr<Shared> shared_; // Shared with the sources, which may outlive this object.
    std::size_t next_tool_ = 0;
};

} // namespace tractus::play
