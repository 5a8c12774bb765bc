#pragma once

#include "drivers/pens/pen_fields.h"
#include "engine/base/time.h"

#include <cstddef>
#include <optional>

namespace tractus::drivers {

// Detects from a pen's reports whether its tablet streams, and at what interval. A streaming tablet
// keeps reporting a pen that rests; others report only changes and are silent while the pen rests.
// Only on a streaming tablet does a silence mean that the pen has left.
//
// The proof of streaming is a run of four equal reports at the tablet's own pace. In 40 public
// recordings of 20 tablets, all streaming tablets send such runs within seconds, and the others do
// not even send three equal reports in a row. The proof is revoked for good when a pen that fell
// silent touches again at the same place without having hovered: it had only rested.
class ReportRhythm {
public:
    // Adds a report received while the pen was in range.
    void push(Timestamp received, PenFields const& fields);

    // Ends the run of reports when the pen leaves: the time until it returns is not a report
    // interval.
    void interrupt_run() { last_.reset(); }

    // Revokes the proof: a pen that had fallen silent had only rested.
    void disprove() { is_disproved_ = true; }

    // Mean interval of the latest reports; no value if the tablet does not stream.
    std::optional<Duration> streaming_interval() const;

private:
    struct Report {
        Timestamp received {};
        PenFields fields;
    };

    void count(Duration interval);

    std::optional<Report> last_ {}; // The previous report; no value after the pen has left.
    Duration mean_ {};              // Mean of the latest intervals.
    std::size_t counted_ = 0;       // Number of intervals in the mean, at most kRemembered.
    std::size_t equal_ = 0;         // Number of consecutive reports equal to the latest one.
    bool is_proved_ = false;
    bool is_disproved_ = false;
};

} // namespace tractus::drivers
