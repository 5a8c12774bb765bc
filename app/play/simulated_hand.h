#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>
#include <vector>

namespace tractus::play {

// The simulated rig as if it were there, with a hand that draws a recording: its devices send what
// they sent then, and its tool lines say which tool the hand takes. The hand waits until begin().
// Before that and when it has drawn, the pen is away and the height sensor, if the recording has
// one, goes on sending where it rests, so that nobody takes it for broken.
//
// Hand and sources belong to one thread, and the sources never wait. The same calls at the same
// times of the clock give the same reports.
class SimulatedHand {
public:
    // `now` is the clock of the reports. All of the log is in memory.
    SimulatedHand(std::shared_ptr<drivers::Log const> log, std::function<Timestamp()> now);

    // One for each device of the recording, in its order.
    std::vector<std::unique_ptr<drivers::ReportSource>> open_sources() const;

    // The recording begins now, if it has not begun.
    void begin();

    // The tool lines whose time has come since the last call, with times of the clock.
    std::vector<drivers::LogTool> take_tools();

    struct Shared; // State that it and its sources share.

private:
    std::shared_ptr<Shared> shared_; // With the sources.
    std::size_t next_tool_ = 0;
};

} // namespace tractus::play
