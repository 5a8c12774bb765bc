#pragma once

#include "drivers/links/packet_link.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::drivers {

// A device that answers commands, with simulated time that advances only while waiting. It can
// simulate all faults of the transmission. A test keeps a pointer to the wire and gives the driver
// a link to it.
struct FakeWire {
    using Answer = std::function<std::vector<std::byte>(std::span<std::byte const>)>;
    using Bytes = std::vector<std::byte>;

    Answer answer {};
    Duration answer_time = std::chrono::milliseconds(1);
    Timestamp now {};
    bool is_plugged = true;

    // Returns the packets that arrive in place of an answer, in order. If this function is empty,
    // answers arrive unchanged.
    std::function<std::vector<Bytes>(Bytes)> disturb {};

    std::vector<Bytes> commands {}; // Commands as they were written.
    // Answers in transit, with their arrival times.
    std::deque<std::pair<Timestamp, Bytes>> on_the_way {};

    // Inserts a packet that was not requested.
    void intrude(Bytes packet) { on_the_way.emplace_back(now, std::move(packet)); }
};

class FakeLink final : public PacketLink {
public:
    explicit FakeLink(FakeWire& wire)
        : wire_(wire)
    {
    }

    Result<void> write(std::span<std::byte const> packet) override
    {
        if (!wire_.is_plugged)
            return fail(Fault::Device, "unplugged");
        wire_.commands.emplace_back(packet.begin(), packet.end());
        auto answer = wire_.answer(packet);
        auto const all = wire_.disturb ? wire_.disturb(std::move(answer))
                                       : std::vector<FakeWire::Bytes> { std::move(answer) };
        for (auto const& one : all)
            wire_.on_the_way.emplace_back(wire_.now + wire_.answer_time, one);
        return {};
    }

    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        if (!wire_.is_plugged)
            return fail(Fault::Device, "unplugged");
        auto const end = wire_.now + timeout;
        if (wire_.on_the_way.empty() || wire_.on_the_way.front().first > end) {
            wire_.now = end;
            return std::optional<RawReport>();
        }
        auto const [time, packet] = wire_.on_the_way.front();
        wire_.on_the_way.pop_front();
        wire_.now = std::max(wire_.now, time);
        RawReport report { .received = wire_.now, .size = packet.size() };
        std::copy(packet.begin(), packet.end(), report.storage.begin());
        return std::optional(report);
    }

    Timestamp now() override { return wire_.now; }
    void sleep(Duration duration) override { wire_.now += duration; }

private:
    FakeWire& wire_;
};

} // namespace tractus::drivers
