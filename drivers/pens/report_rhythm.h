#pragma once

#include "drivers/pens/pen_fields.h"
#include "engine/base/time.h"

#include <cstddef>
#include <optional>

namespace tractus::drivers {

// Learns from a pen's reports whether its tablet streams and how fast. A tablet streams if it
// reports a pen that rests again and again; others report changes alone, and are silent for as long
// as the pen rests. Only of a tablet that streams is silence a sign that the pen is gone.
//
// The proof of streaming is a run of four equal reports at the tablet's own pace: in 40 public
// recordings of 20 tablets all that stream send such runs within seconds, and of those that do not
// none sends three. It is taken back for good when a pen that fell silent touches again where it
// was, without having hovered: then it had only rested.
class ReportRhythm {
public:
    // The next report that tells of the pen in range.
    void push(Timestamp received, PenFields const& fields);

    // The pen is away: the time until it is back is no interval between reports.
    void break_off() { last_.reset(); }

    // A pen that had fallen silent had only rested.
    void disprove() { is_disproved_ = true; }

    // The mean interval between the newest reports, if the tablet streams.
    std::optional<Duration> streaming_interval() const;

private:
    struct Report {
        Timestamp received {};
        PenFields fields;
    };

    void count(Duration interval);

    std::optional<Report> last_ {}; // No value: the pen has been away since.
    Duration mean_ {};              // Mean interval of the newest reports.
    std::size_t counted_ = 0;       // Intervals in it, at most kRemembered.
    std::size_t equal_ = 0;         // Reports just before this one that are like it.
    bool is_proved_ = false;
    bool is_disproved_ = false;
};

} // namespace tractus::drivers
