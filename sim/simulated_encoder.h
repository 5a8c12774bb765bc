#pragma once

#include "drivers/gpio/gpio_edges.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace tractus::sim {

// Whether a line is high where the encoder is at this count: of a period of four counts, A is in
// its second and third quarter, B in its third and fourth.
bool is_encoder_line_high(drivers::QuadratureEdge::Line line, std::int64_t count);

// A quadrature encoder's two lines as the kernel tells them: its edges, stamped and numbered, as
// something moves it. Time passes only while somebody waits for edges, in steps of kStep: the
// encoder must not move by more than a few counts in one.
class SimulatedEncoder final : public drivers::GpioEdges {
public:
    static constexpr Duration kStep = std::chrono::microseconds(20);

    // Where it is at a time, in counts, four to a period.
    using Position = std::function<double(Timestamp)>;

    struct Options {
        std::set<std::uint32_t> lost {};            // Edges by their number that never arrive.
        std::set<std::uint32_t> unnumbered {};      // Lost edges that nobody numbers either.
        std::optional<std::uint32_t> gone_after {}; // Edge with which the chip goes away.
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
    std::uint32_t edge_count_ = 0; // Before any is lost.
    std::uint32_t number_ = 0;
};

} // namespace tractus::sim
