#include "calib/lowest_stop.h"

#include <algorithm>
#include <cmath>

namespace tractus::calib {

namespace {

constexpr Duration kRests = std::chrono::milliseconds(300);
constexpr double kRestTolerance_mm = 0.5;
// A surface counts as let down only if it comes from at least this far above its resting height.
constexpr double kComesFrom_mm = 10;
// A surface turns if it goes up again by at least this much.
constexpr double kGoesUp_mm = 10;
constexpr double kSmooth_s = 0.003;
constexpr double kSamePositionTolerance_mm = 0.3;
constexpr double kBelow_mm = 1;   // A height this far below a resting place counts as below it.
constexpr double kMinMove_mm = 2; // Least movement of the stop that is reported.
// Greatest rise of the stop that is reported; a surface resting higher was held, not let down.
constexpr double kMaxMove_mm = 30;
constexpr std::size_t kTimesOfStop = 3;
// Rests needed at a higher place, since a hand can rest above a stop, too.
constexpr std::size_t kTimesHigher = 4;
// Rests needed at a lower place; fewer suffice, since nothing goes below a stop.
constexpr std::size_t kTimesLower = 2;

} // namespace

bool LowestStop::Place::is_at(double height_mm) const
{
    return std::abs(height_mm - mm) <= kSamePositionTolerance_mm;
}

void LowestStop::Place::add(double height_mm)
{
    mm += (height_mm - mm) / static_cast<double>(++times);
}

std::optional<LowestStop::Moved> LowestStop::push(Timestamp time, double height_mm)
{
    auto place_mm = place_of_turn(time, height_mm);
    lowest_mm_ = std::min(lowest_mm_, height_mm);
    if (auto const rest_mm = place_of_rest(time, height_mm))
        place_mm = rest_mm;
    if (!place_mm)
        return std::nullopt;
    auto const moved = let_down(time, *place_mm);
    lowest_mm_ = height_mm;
    highest_mm_ = valley_mm_ = smooth_mm_;
    return moved;
}

std::optional<double> LowestStop::place_of_rest(Timestamp time, double height_mm)
{
    bool const goes_on = rests_since_ && time >= *rests_since_
        && std::abs(height_mm - rest_mm_) <= kRestTolerance_mm;
    if (!goes_on) {
        rests_since_ = time;
        rest_mm_ = height_mm;
        rest_count_ = 0;
        is_rest_reported_ = false;
    }
    rest_mm_ += (height_mm - rest_mm_) / static_cast<double>(++rest_count_);
    if (is_rest_reported_ || time - *rests_since_ < kRests)
        return std::nullopt;
    is_rest_reported_ = true;
    bool const is_let_down = highest_mm_ - rest_mm_ >= kComesFrom_mm;
    highest_mm_ = valley_mm_ = smooth_mm_;
    return is_let_down ? std::optional(rest_mm_) : std::nullopt;
}

// Finds the lowest point of a movement down and up. A surface that rests there in between has been
// let down already.
std::optional<double> LowestStop::place_of_turn(Timestamp time, double height_mm)
{
    if (!rests_since_ || time < last_time_)
        smooth_mm_ = highest_mm_ = valley_mm_ = lowest_mm_ = height_mm;
    else
        smooth_mm_
            += (height_mm - smooth_mm_) * std::min(1.0, to_seconds(time - last_time_) / kSmooth_s);
    last_time_ = time;
    if (smooth_mm_ > highest_mm_ && highest_mm_ - valley_mm_ < kComesFrom_mm)
        highest_mm_ = valley_mm_ = smooth_mm_;
    valley_mm_ = std::min(valley_mm_, smooth_mm_);
    bool const has_turned
        = highest_mm_ - valley_mm_ >= kComesFrom_mm && smooth_mm_ - valley_mm_ >= kGoesUp_mm;
    return has_turned ? std::optional(valley_mm_) : std::nullopt;
}

std::optional<LowestStop::Moved> LowestStop::let_down(Timestamp time, double height_mm)
{
    bool const is_known = stop_ && stop_->times >= kTimesOfStop;
    if (stop_ && stop_->is_at(height_mm)) {
        stop_->add(height_mm);
        next_.reset();
        return std::nullopt;
    }
    if (!is_known) {
        if (!stop_ || height_mm < stop_->mm)
            stop_ = Place { height_mm, 1 };
        return std::nullopt;
    }
    double const move_mm = height_mm - stop_->mm;
    if (move_mm > kMaxMove_mm)
        return std::nullopt;
    if (next_ && next_->is_at(height_mm) && lowest_mm_ >= next_->mm - kBelow_mm)
        next_->add(height_mm);
    else
        next_ = Place { height_mm, 1 };
    if (std::abs(move_mm) < kMinMove_mm
        || next_->times < (move_mm > 0 ? kTimesHigher : kTimesLower))
        return std::nullopt;
    Moved const moved { time, stop_->mm, next_->mm };
    stop_ = Place { next_->mm, kTimesOfStop };
    next_.reset();
    return moved;
}

} // namespace tractus::calib
