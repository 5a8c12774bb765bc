#pragma once

#include "drivers/gpio/gpio_edges.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace tractus::sim {

// Returns whether a line is high when the encoder is at this count: in a period of four counts, A
// is high in the second and third quarter, B in the third and fourth.
bool is_encoder_line_high(drivers::QuadratureEdge::Line line, std::int64_t count);

// The two lines of a moving quadrature encoder, as the kernel reports them: edges with times and
// sequence numbers. Time advances only while the caller waits for edges, in steps of kStep; the
// encoder must not move by more than a few counts in one step.
class SimulatedEncoder final : public drivers::GpioEdges {
public:
    static constexpr Duration kStep = std::chrono::microseconds(20);

    // Returns the encoder's position at a time, in counts, of which four make a period.
    using Position = std::function<double(Timestamp)>;

    struct Options {
        std::set<std::uint32_t> lost {}; // Numbers of edges that never arrive.
        // Numbers of lost edges that leave no gap in the sequence numbers.
        std::set<std::uint32_t> unnumbered {};
        std::optional<std::uint32_t> gone_after {}; // Edge at which the chip disappears.
    };

    SimulatedEncoder(Position position, Options options);

    Result<void> read(Duration timeout, std::vector<drivers::QuadratureEdge>& edges) override;
    Timestamp now() override { return now_; }
    drivers::Quadrature::Beginning beginning() const override;

private:
    void step(std::vector<drivers::QuadratureEdge>& edges);
    void emit(std::int64_t to, std::vector<drivers::QuadratureEdge>& edges);

    Position position_;
    Options options_;
    Timestamp now_ {};
    std::int64_t count_;
    std::int64_t first_count_;
    std::uint32_t edge_count_ = 0; // Number of edges, including lost ones.
    std::uint32_t number_ = 0;
};

} // namespace tractus::sim
