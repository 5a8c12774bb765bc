#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace tractus::terminal {

// Shows on standard error what the program is doing, and measures the time of each stage. Stages
// shorter than a second are not shown. On a terminal the line is updated in place; elsewhere each
// stage prints at most one line per second.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    // Ends the current stage and starts another. `total` is the number of its steps, or 0 if
    // unknown.
    void begin(std::string stage, std::size_t total = 0);

    // Counts a step of the current stage as done.
    void step();

    // Ends the current stage.
    void finish();

    struct StageTime {
        std::string stage;
        double seconds = 0;
    };
    std::vector<StageTime> const& times() const { return times_; }

private:
    using Clock = std::chrono::steady_clock;

    void show();

    bool on_terminal_ = false;
    bool line_open_ = false;
    std::string stage_;
    std::size_t done_ = 0;
    std::size_t total_ = 0;
    Clock::time_point begun_ {};
    Clock::time_point shown_ {};
    std::vector<StageTime> times_;
};

} // namespace tractus::terminal
