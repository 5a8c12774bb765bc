#include "sim/mcp3208_model.h"

#include "engine/base/check.h"

#include <algorithm>
#include <utility>

namespace tractus::sim {

namespace {

// Number of the clock pulse on which the last bit of the channel is read.
constexpr unsigned kCommandEnd = 5;
constexpr unsigned kNullClock = 6;
constexpr unsigned kSingleEnded = 8;

} // namespace

Mcp3208Model::Mcp3208Model(Inputs inputs, Options options)
    : inputs_(std::move(inputs))
    , options_(options)
{
    CHECK(inputs_ && options_.bits >= 2 && options_.bits <= 16);
}

void Mcp3208Model::break_wire(Wire wire)
{
    broken_ |= 1U << static_cast<unsigned>(wire);
}

void Mcp3208Model::mend_wire(Wire wire)
{
    broken_ &= ~(1U << static_cast<unsigned>(wire));
}

void Mcp3208Model::set_pins(Timestamp time, Pins const& pins)
{
    CHECK(time >= now_);
    now_ = time;
    Pins const seen { .clk = pins.clk && !is_broken(Wire::Clk),
                      .din = pins.din && !is_broken(Wire::Din),
                      .cs = pins.cs || is_broken(Wire::Cs) };
    auto const before = std::exchange(pins_, seen);
    if (seen.cs) {
        clock_ = 0;
        command_ = 0;
        dout_.reset();
        return;
    }
    if (before.cs) // The chip has just been selected: a simultaneous edge of CLK does not count.
        return;
    if (!before.clk && seen.clk)
        rise(before.din);
    else if (before.clk && !seen.clk)
        fall();
}

std::optional<bool> Mcp3208Model::dout() const
{
    return is_broken(Wire::Dout) ? std::nullopt : dout_;
}

void Mcp3208Model::rise(bool din)
{
    if (clock_ == 0) {
        clock_ = din ? 1 : 0;
        return;
    }
    ++clock_;
    if (clock_ <= kCommandEnd)
        command_ = command_ << 1 | static_cast<unsigned>(din);
}

void Mcp3208Model::fall()
{
    if (clock_ < kNullClock)
        return;
    if (clock_ == kNullClock) {
        unsigned const channel = command_ & 7;
        held_ = std::clamp(inputs_(channel, now_), 0.0, 1.0);
        if (!(command_ & kSingleEnded)) // The second input of the pair is the channel's neighbour.
            held_ = std::max(0.0, held_ - std::clamp(inputs_(channel ^ 1, now_), 0.0, 1.0));
        held_since_ = now_;
        code_ = 0;
        dout_ = false;
        return;
    }
    // Position of the bit; 1 is the most significant one.
    unsigned const place = clock_ - kNullClock;
    if (place <= options_.bits) {
        decide_next_bit();
        dout_ = code_ >> (options_.bits - place) & 1;
        conversions_ += place == options_.bits;
        return;
    }
    // Position of the repeated bit; 1 is the second lowest one.
    unsigned const repeated = place - options_.bits;
    dout_ = repeated < options_.bits && (code_ >> repeated & 1);
}

double Mcp3208Model::held_at(Timestamp time) const
{
    return held_ - options_.droop_per_second * to_seconds(time - held_since_);
}

// Decides the next bit by successive approximation, from the present voltage of the hold capacitor.
void Mcp3208Model::decide_next_bit()
{
    unsigned const place = clock_ - kNullClock;
    std::uint32_t const candidate = code_ | 1U << (options_.bits - place);
    if (held_at(now_) * static_cast<double>(1U << options_.bits) >= candidate)
        code_ = candidate;
}

} // namespace tractus::sim
