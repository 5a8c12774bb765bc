#include "sim/simulated_encoder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::sim {

bool is_encoder_line_high(drivers::QuadratureEdge::Line line, std::int64_t count)
{
    auto const quarter = count & 3;
    return line == drivers::QuadratureEdge::Line::A ? quarter == 1 || quarter == 2 : quarter >= 2;
}

static std::int64_t whole_counts(double position)
{
    return static_cast<std::int64_t>(std::floor(position));
}

SimulatedEncoder::SimulatedEncoder(Position position, Options options)
    : position_(std::move(position))
    , options_(std::move(options))
    , count_(whole_counts(position_(now_)))
    , first_count_(count_)
{
}

drivers::Quadrature::Beginning SimulatedEncoder::beginning() const
{
    return { .a = is_encoder_line_high(drivers::QuadratureEdge::Line::A, first_count_),
             .b = is_encoder_line_high(drivers::QuadratureEdge::Line::B, first_count_) };
}

void SimulatedEncoder::emit(std::int64_t to, std::vector<drivers::QuadratureEdge>& edges)
{
    auto const line = is_encoder_line_high(drivers::QuadratureEdge::Line::A, to)
            != is_encoder_line_high(drivers::QuadratureEdge::Line::A, count_)
        ? drivers::QuadratureEdge::Line::A
        : drivers::QuadratureEdge::Line::B;
    count_ = to;
    ++edge_count_;
    if (options_.unnumbered.contains(edge_count_))
        return;
    ++number_;
    if (!options_.lost.contains(edge_count_))
        edges.push_back({ .time = now_,
                          .line = line,
                          .is_rising = is_encoder_line_high(line, to),
                          .number = number_ });
}

void SimulatedEncoder::step(std::vector<drivers::QuadratureEdge>& edges)
{
    now_ += kStep;
    auto const target = whole_counts(position_(now_));
    while (count_ != target)
        emit(count_ + (target > count_ ? 1 : -1), edges);
}

Result<void> SimulatedEncoder::read(Duration timeout, std::vector<drivers::QuadratureEdge>& edges)
{
    auto const end = now_ + std::max(timeout, Duration(0));
    while (now_ < end && edges.empty())
        step(edges);
    if (options_.gone_after && edge_count_ > *options_.gone_after)
        return fail(Fault::Device, "lost the lines of the GPIO chip: it is gone");
    return {};
}

} // namespace tractus::sim
