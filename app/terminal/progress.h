#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace tractus::terminal {

// Tells whoever waits what is being done, and keeps the time that each stage took. A stage that is
// over within a second says nothing. On a terminal the line is rewritten in place; elsewhere each
// stage says at most one line a second. Standard error.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    // Begins a stage, which ends the one before. `total` is how many steps it has, 0 if not known.
    void begin(std::string stage, std::size_t total = 0);

    // One step of the stage is done.
    void step();

    // Ends the last stage.
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
