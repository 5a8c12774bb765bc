#include "calib/height_monitor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/core.h>

namespace tractus::calib {

namespace {

// Jumps within this time of each other count as one, such as a jump and its return.
constexpr Duration kJumpLasts = std::chrono::milliseconds(500);
// Time for which a moved stop is reported, long enough for the message to be read.
constexpr Duration kStopIsTold = std::chrono::seconds(10);

// If a reading changes and changes back within this time, that is noise. A sensor with at least
// kNoisyFlickers such changes has noise.
constexpr Duration kFlicker = std::chrono::milliseconds(100);
constexpr std::size_t kNoisyFlickers = 5;

bool is_worse(HeightFault const& a, HeightFault const& b)
{
    if (a.kind != HeightFaultKind::Jump && a.kind != HeightFaultKind::Stop)
        return a.end - a.begin > b.end - b.begin;
    return a.speed_mm_per_s != b.speed_mm_per_s ? a.speed_mm_per_s > b.speed_mm_per_s
                                                : std::abs(a.step_mm) > std::abs(b.step_mm);
}

void add(HeightFaultTotal& total, HeightFault const& fault)
{
    if (total.count++ == 0 || is_worse(fault, total.worst))
        total.worst = fault;
    total.duration += fault.end - fault.begin;
}

} // namespace

HeightMonitor::HeightMonitor(Rig const& rig, HeightMonitorLimits const& limits)
    : rig_(rig)
    , limits_(limits)
{
}

void HeightMonitor::push(drivers::HeightSample const& sample)
{
    advance(sample.time);
    close(HeightFaultKind::Silence);
    alive_ = std::max(alive_.value_or(sample.time), sample.time);
    watch_rail(sample);
    watch_jump(sample);
    watch_step(sample);
    watch_stop(sample);
    watch_stuck(sample);
    watch_rate(sample.time);
    last_ = sample;
}

void HeightMonitor::advance(Timestamp now)
{
    close_old(HeightFaultKind::Jump, kJumpLasts, now);
    close_old(HeightFaultKind::Stop, kStopIsTold, now);
    if (!alive_)
        alive_ = now;
    if (now - *alive_ > limits_.silence_after)
        see({ .kind = HeightFaultKind::Silence, .begin = *alive_, .end = now });
}

// Begins a fault of this kind, or extends it if it is already present.
void HeightMonitor::see(HeightFault const& fault)
{
    auto& open = watch(fault.kind).open;
    if (!open) {
        open = fault;
        return;
    }
    open->end = std::max(open->end, fault.end);
    if (fault.speed_mm_per_s > open->speed_mm_per_s) {
        open->speed_mm_per_s = fault.speed_mm_per_s;
        open->counts = fault.counts;
    }
    if (std::abs(fault.step_mm) > std::abs(open->step_mm))
        open->step_mm = fault.step_mm;
}

void HeightMonitor::close(HeightFaultKind kind)
{
    auto& [open, closed] = watch(kind);
    if (open)
        add(closed, *open);
    open.reset();
}

void HeightMonitor::close_old(HeightFaultKind kind, Duration lasts, Timestamp now)
{
    auto const& open = watch(kind).open;
    if (open && now - open->end > lasts)
        close(kind);
}

void HeightMonitor::restart_after_reconnection()
{
    for (auto const kind : { HeightFaultKind::Rail, HeightFaultKind::Stuck })
        close(kind);
    judge_ = {};
    believed_.clear();
    doubts_last_ = false;
    doubts_ = 0;
    doubted_.reset();
    last_.reset();
    rail_since_.reset();
    path_.clear();
    recent_.clear();
}

bool HeightMonitor::is_on_rail(drivers::HeightSample const& sample) const
{
    auto const margin = limits_.rail_margin * sample.full_scale;
    return sample.counts <= margin || sample.counts >= sample.full_scale - margin;
}

void HeightMonitor::watch_rail(drivers::HeightSample const& sample)
{
    if (!is_on_rail(sample)) {
        rail_since_.reset();
        close(HeightFaultKind::Rail);
        return;
    }
    if (!rail_since_)
        rail_since_ = sample.time;
    if (sample.time - *rail_since_ >= limits_.rail_after)
        see({ .kind = HeightFaultKind::Rail,
              .begin = *rail_since_,
              .end = sample.time,
              .counts = sample.counts });
}

std::optional<double> HeightMonitor::height_of(drivers::HeightSample const& sample) const
{
    if (sample.full_scale != rig_.full_scale_counts || is_on_rail(sample))
        return std::nullopt;
    return height_mm(rig_.height_model, sample.counts);
}

// Reports a jump when doubted readings have turned out to be wrong, or to be a step.
void HeightMonitor::watch_jump(drivers::HeightSample const& sample)
{
    auto const height = height_of(sample);
    doubts_last_ = false;
    believed_.clear();
    if (!height) {
        judge_.miss();
        return;
    }
    auto const count_mm = mm_per_count_at(rig_.height_model, sample.counts).value_or(0);
    auto const verdict
        = judge_.judge({ sample.time, sample.time, *height }, std::abs(count_mm), believed_);
    doubts_last_ = verdict == HeightJudge::Verdict::Doubted;
    if (doubts_last_)
        return doubt(sample, *height);
    bool const all_were_right
        = verdict == HeightJudge::Verdict::Believed && believed_.size() > doubts_;
    if (doubted_ && !all_were_right)
        see(*doubted_);
    if (verdict == HeightJudge::Verdict::Step)
        path_.clear(); // Otherwise the jump would be reported as a slow step as well.
    doubted_.reset();
    doubts_ = 0;
}

// Records a doubted reading. Doubted readings on the way to an end of the converter's range and
// back belong to the fault of that kind, not to a jump.
void HeightMonitor::doubt(drivers::HeightSample const& sample, double height_mm)
{
    // Intervals between arrivals shorter than this do not show when readings were taken, because
    // USB delivers in bursts.
    constexpr Duration kShortest = std::chrono::microseconds(2500);
    ++doubts_;
    auto const before = last_ ? height_of(*last_) : std::nullopt;
    if (!before)
        return;
    auto const duration = std::max(sample.time - last_->time, kShortest);
    double const speed_mm_per_s = std::abs(height_mm - *before) / to_seconds(duration);
    if (!doubted_)
        doubted_ = HeightFault { .kind = HeightFaultKind::Jump,
                                 .begin = sample.time,
                                 .end = sample.time,
                                 .counts = sample.counts };
    if (speed_mm_per_s > doubted_->speed_mm_per_s) {
        doubted_->speed_mm_per_s = speed_mm_per_s;
        doubted_->counts = sample.counts;
    }
}

namespace {

// A line fitted through heights on one side of a step.
struct Side {
    double seconds = 0; // Mean time of the heights, relative to the newest reading.
    double mm = 0;      // Height of the line at its mean time.
    double mm_per_s = 0;
    double scatter_mm = 0; // Standard deviation of the heights about the line.
    std::size_t count = 0;
};

template<typename Heights>
Side line_through(Heights const& heights, Timestamp newest, Duration from, Duration to)
{
    Side side;
    double squares = 0;
    double products = 0;
    double heights_squared = 0;
    for (auto const& height : heights) {
        auto const age = newest - height.time;
        if (age < from || age > to)
            continue;
        double const seconds = -to_seconds(age);
        double const n = static_cast<double>(++side.count);
        double const time_off = seconds - side.seconds;
        double const mm_off = height.mm - side.mm;
        side.seconds += time_off / n;
        side.mm += mm_off / n;
        squares += time_off * (seconds - side.seconds);
        products += time_off * (height.mm - side.mm);
        heights_squared += mm_off * (height.mm - side.mm);
    }
    if (squares > 0) {
        side.mm_per_s = products / squares;
        side.scatter_mm = std::sqrt(std::max(0.0, heights_squared - products * side.mm_per_s)
                                    / static_cast<double>(side.count));
    }
    return side;
}

constexpr Duration kSide = std::chrono::milliseconds(30);
constexpr Duration kStepTakes = std::chrono::milliseconds(30);

} // namespace

// Looks for a slow step: compares the heights of the last 30 ms with those of the 30 ms that ended
// 30 ms earlier. Without a step, the height between their middles changes by the mean of both
// speeds times the time, exactly so under a steady acceleration.
void HeightMonitor::watch_step(drivers::HeightSample const& sample)
{
    constexpr std::size_t kMinForStep = 3;
    if (!height_of(sample))
        path_.clear();
    for (auto const& reading : believed_) {
        bool const is_gap = !path_.empty()
            && (reading.arrival - path_.back().time > kStepTakes
                || reading.arrival < path_.back().time);
        if (is_gap)
            // A change across a gap in the readings must not be reported as a slow step.
            path_.clear();
        path_.push_back({ reading.arrival, reading.height_mm });
    }
    if (believed_.empty() || path_.empty())
        return;
    while (sample.time - path_.front().time > 2 * kSide + kStepTakes)
        path_.pop_front();
    auto const after = line_through(path_, sample.time, {}, kSide);
    auto const before
        = line_through(path_, sample.time, kSide + kStepTakes, 2 * kSide + kStepTakes);
    if (std::min(after.count, before.count) < kMinForStep
        || std::abs(after.mm_per_s - before.mm_per_s) > limits_.step_speed_mm_per_s)
        return;
    double const way_mm = (after.mm_per_s + before.mm_per_s) / 2 * (after.seconds - before.seconds);
    double const step_mm = after.mm - before.mm - way_mm;
    double const scatter_mm = std::max(after.scatter_mm, before.scatter_mm);
    auto const when = sample.time - kSide - kStepTakes / 2;
    if (std::abs(step_mm) > limits_.step_mm + limits_.step_scatters * scatter_mm)
        see({ .kind = HeightFaultKind::Jump,
              .begin = when,
              .end = when,
              .counts = sample.counts,
              .step_mm = step_mm });
}

void HeightMonitor::watch_stop(drivers::HeightSample const& sample)
{
    auto const height = height_of(sample);
    if (!height)
        return;
    if (auto const moved = stop_.push(sample.time, *height))
        see({ .kind = HeightFaultKind::Stop,
              .begin = moved->time,
              .end = moved->time,
              .counts = sample.counts,
              .step_mm = moved->to_mm - moved->from_mm });
}

void HeightMonitor::learn_noise(drivers::HeightSample const& sample)
{
    int const sign = sample.counts > last_->counts ? 1 : -1;
    if (sign == -last_change_sign_ && sample.time - last_change_ < kFlicker)
        ++flickers_;
    last_change_ = sample.time;
    last_change_sign_ = sign;
}

// Detects a stuck sensor. A reading on a rail has no noise, and is a fault already.
void HeightMonitor::watch_stuck(drivers::HeightSample const& sample)
{
    bool const is_same = last_ && last_->counts == sample.counts;
    if (last_ && !is_same)
        learn_noise(sample);
    if (!is_same || is_on_rail(sample)) {
        same_since_ = sample.time;
        close(HeightFaultKind::Stuck);
        return;
    }
    auto const limit
        = flickers_ >= kNoisyFlickers ? limits_.stuck_after : limits_.stuck_without_noise_after;
    if (sample.time - same_since_ >= limit)
        see({ .kind = HeightFaultKind::Stuck,
              .begin = same_since_,
              .end = sample.time,
              .counts = sample.counts });
}

void HeightMonitor::watch_rate(Timestamp time)
{
    constexpr Duration kSpan = std::chrono::seconds(1);
    // Most readings remembered; USB allows 8,000 a second.
    constexpr std::size_t kMaxPerSecond = 20'000;
    if (!recent_.empty() && time < recent_.back())
        recent_.clear(); // Times go back in concatenated logs.
    recent_.push_back(time);
    while (time - recent_.front() > kSpan || recent_.size() > kMaxPerSecond)
        recent_.pop_front();
}

double HeightMonitor::rate_hz() const
{
    if (recent_.size() < 2 || recent_.back() <= recent_.front())
        return 0;
    return static_cast<double>(recent_.size() - 1) / to_seconds(recent_.back() - recent_.front());
}

std::optional<HeightFault> HeightMonitor::present() const
{
    for (auto const& one : watches_)
        if (one.open)
            return one.open;
    return std::nullopt;
}

HeightFaultTotal HeightMonitor::total(HeightFaultKind kind) const
{
    auto const& [open, closed] = watch(kind);
    auto result = closed;
    if (open)
        add(result, *open);
    return result;
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
        return fmt::format("lowest stop {:.0f} mm {} than before: has the string slipped?",
                           std::abs(fault.step_mm), fault.step_mm > 0 ? "higher" : "lower");
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
            return fmt::format("the height stepped {}, by {:+.1f} mm at {:.1f} s, in the midst of "
                               "a movement: if the string slipped, zero it with \"tractus "
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
        return fmt::format("the surface's lowest stop reads {:.1f} mm {} than before, as told at "
                           "{:.1f} s: if nothing lies under it, the string has slipped: zero it "
                           "with \"tractus calibrate zero\"",
                           std::abs(worst.step_mm), worst.step_mm > 0 ? "higher" : "lower",
                           to_seconds(worst.begin - start));
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
