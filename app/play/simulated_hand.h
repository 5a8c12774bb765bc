#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>
#include <vector>

namespace tractus::play {

// Simulated rig whose hand draws a recording: its devices send the recorded reports, and the log's
// tool lines select the tools. It waits for begin(). Before and after the recording the pen is
// away, and the height sensor, if there is one, keeps sending its resting value, so that it is not
// diagnosed as broken. Hand and sources belong to one thread, and the sources never wait.
// Deterministic for equal calls at equal times.
class SimulatedHand {
public:
    // `now` is the clock that stamps the reports. The log must be completely in memory.
    SimulatedHand(std::shared_ptr<drivers::Log const> log, std::function<Timestamp()> now);

    // One source for each device of the recording, in its order.
    std::vector<std::unique_ptr<drivers::ReportSource>> open_sources() const;

    // Starts the recording, unless it has already begun.
    void begin();

    // Tool lines that became due since the last call, with times of the clock.
    std::vector<drivers::LogTool> take_tools();

    struct Shared; // State shared with the sources.

private:
    std::shared_ptr<Shared> shared_; // State shared with the sources; see Shared.
    std::size_t next_tool_ = 0;
};

} // namespace tractus::play
