#include "calib/height_monitor.h"

#include <cmath>
#include <cstdlib>
#include <fmt/core.h>
#include <string_view>

namespace tractus::calib {

static std::string_view name_of_stop(HeightFault const& fault)
{
    return fault.is_highest_stop ? "highest" : "lowest";
}

std::string describe_fault(HeightFault const& fault)
{
    double const seconds = to_seconds(fault.end - fault.begin);
    switch (fault.kind) {
    case HeightFaultKind::Silence:
        return fmt::format("height sensor silent for {:.0f} s: is it plugged in?",
                           std::floor(seconds));
    case HeightFaultKind::Rail:
        return fmt::format("height sensor reads {}, the end of its range: wiper or cable open?",
                           fault.counts);
    case HeightFaultKind::Jump:
        if (fault.speed_mm_per_s == 0)
            return fmt::format("height stepped by {:+.0f} mm: has the string slipped? then zero it",
                               fault.step_mm);
        return fmt::format("height jumped at {:.1f} m/s: string slipping or contact loose?",
                           fault.speed_mm_per_s / 1000);
    case HeightFaultKind::Stuck:
        return fmt::format("height stuck at {} for {:.0f} s: string torn or jammed?", fault.counts,
                           seconds);
    case HeightFaultKind::Stop:
        return fmt::format("{} stop {:.0f} mm {} than before: has the string slipped?",
                           name_of_stop(fault), std::abs(fault.step_mm),
                           fault.step_mm > 0 ? "higher" : "lower");
    }
    return {};
}

namespace {

// Prints "once, for 0.3 s at 12.1 s" or "3 times, for 2.3 s in all, the longest at 12.1 s".
std::string how_long(HeightFaultTotal const& total, Timestamp start)
{
    double const at_s = to_seconds(total.worst.begin - start);
    double const seconds = to_seconds(total.duration);
    if (total.count == 1)
        return fmt::format("once, for {:.1f} s at {:.1f} s", seconds, at_s);
    return fmt::format("{} times, for {:.1f} s in all, the longest at {:.1f} s", total.count,
                       seconds, at_s);
}

std::string describe_total(HeightFaultKind kind, HeightFaultTotal const& total, Timestamp start)
{
    auto const& worst = total.worst;
    switch (kind) {
    case HeightFaultKind::Silence:
        return fmt::format("the height sensor fell silent {}: check its plug and its cable",
                           how_long(total, start));
    case HeightFaultKind::Rail:
        return fmt::format("the height sensor read {}, an end of its range, {}: its wiper or its "
                           "cable is open, or the spool is at its stop",
                           worst.counts, how_long(total, start));
    case HeightFaultKind::Jump:
        if (worst.speed_mm_per_s == 0)
            return fmt::format("the height stepped {}, by {:+.1f} mm at {:.1f} s, more abruptly "
                               "than a hand: if the string slipped, zero it with \"tractus "
                               "calibrate zero\"",
                               total.count == 1 ? "once" : fmt::format("{} times", total.count),
                               worst.step_mm, to_seconds(worst.begin - start));
        return fmt::format("the height jumped {}, at up to {:.1f} m/s at {:.1f} s, more suddenly "
                           "than a hand: the string slips or a contact is loose",
                           total.count == 1 ? "once" : fmt::format("{} times", total.count),
                           worst.speed_mm_per_s / 1000, to_seconds(worst.begin - start));
    case HeightFaultKind::Stuck:
        return fmt::format("the height sensor stood still at {} {}: if the surface moved then, the "
                           "string is torn or jammed",
                           worst.counts, how_long(total, start));
    case HeightFaultKind::Stop:
        return fmt::format("the surface's {} stop reads {:.1f} mm {} than before, as told at "
                           "{:.1f} s: if nothing {} it, the string has slipped: zero it "
                           "with \"tractus calibrate zero\"",
                           name_of_stop(worst), std::abs(worst.step_mm),
                           worst.step_mm > 0 ? "higher" : "lower", to_seconds(worst.begin - start),
                           worst.is_highest_stop ? "is in the way above" : "lies under");
    }
    return {};
}

} // namespace

std::vector<std::string> describe_faults(HeightMonitor const& monitor, Timestamp start)
{
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < kHeightFaultKinds; ++i) {
        auto const kind = static_cast<HeightFaultKind>(i);
        if (auto const total = monitor.total(kind); total.count > 0)
            sentences.push_back(describe_total(kind, total, start));
    }
    return sentences;
}

} // namespace tractus::calib
