#include "sim/serial_board.h"

#include <chrono>
#include <fmt/core.h>
#include <span>
#include <utility>

namespace tractus::sim {

SerialBoard::SerialBoard(KernelDevice& port, HeightCurve heights, Options const& options)
    : port_(port)
    , heights_(std::move(heights))
    , period_(from_seconds(1 / options.rate_hz))
    , full_scale_(options.full_scale.value_or(heights_.full_scale()))
{
}

Result<void> SerialBoard::play(Timestamp now)
{
    constexpr Duration kLongestPause = std::chrono::seconds(1);
    if (next_line_ == Timestamp::min() || now - next_line_ > kLongestPause)
        next_line_ = now;
    for (; next_line_ <= now; next_line_ += period_)
        TRY(print_line());
    return {};
}

Result<void> SerialBoard::print_line()
{
    auto const since_begin = begin_ ? next_line_ - *begin_ : Duration::zero();
    auto const line
        = fmt::format("{}\r\n", heights_.counts_at(Timestamp(since_begin), full_scale_));
    return port_.send(std::as_bytes(std::span(line)));
}

bool SerialBoard::is_over(Timestamp now) const
{
    return begin_ && now - *begin_ > heights_.end().time_since_epoch();
}

} // namespace tractus::sim
