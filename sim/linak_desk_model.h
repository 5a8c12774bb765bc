#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// A motorised desk with LINAK's cable USB2LIN06, as seen through its feature reports
// (firmware-notes/desk.md). After initialisation it reports its height on request. It counts
// commands that would move it.
class LinakDeskModel {
public:
    static constexpr std::size_t kReportBytes = 64;

    // Simulates a power failure: the desk has to be initialised again.
    void lose_power() { initialisation_ = Initialisation::None; }

    // Simulates an actuator that has lost its position and does not recover by initialisation.
    void lose_position() { has_place_ = false; }

    // Moves the desk as if with its own keys, to a height in tenths of a millimetre above its
    // lowest position.
    void move_to(std::int16_t tenths_mm);

    // Returns the feature report with this id; no value if there is none.
    std::optional<std::vector<std::byte>> get_feature(std::uint8_t id);

    // Sets a feature report. Returns false if there is no such report.
    bool set_feature(std::span<std::byte const> report);

    // Number of movement commands received; the program must never send any.
    std::size_t movement_count() const { return movement_count_; }

    // Returns the report descriptor (HID 1.11, section 6.2.2): features 1 to 6 with 63 bytes on a
    // vendor-defined page.
    static std::vector<std::byte> report_descriptor();

private:
    enum class Initialisation { None, Begun, Done };

    bool is_ready() const { return has_place_ && initialisation_ == Initialisation::Done; }

    Initialisation initialisation_ = Initialisation::None;
    bool has_place_ = true;
    std::int16_t height_ = 0;
    std::int16_t requested_height_ = 0; // Height when the host last requested it.
    std::size_t movement_count_ = 0;
};

} // namespace tractus::sim
