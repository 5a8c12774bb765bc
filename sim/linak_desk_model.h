#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// A motorised desk behind LINAK's cable USB2LIN06 as its feature reports show it
// (firmware-notes/desk.md): it tells its height when it is asked, after it was initialised, and
// counts what would move it.
class LinakDeskModel {
public:
    static constexpr std::size_t kReportBytes = 64;

    // Loses with the power what the desk does not do by itself: it has to be initialised again.
    void lose_power() { initialisation_ = Initialisation::None; }

    // Loses the place for good: that of an actuator that does not know it, whatever it is told.
    void lose_place() { has_place_ = false; }

    // Where somebody has moved it with its own keys, in tenths of a millimetre above its lowest
    // position.
    void move_to(std::int16_t tenths_mm);

    // The feature report of this id; no value if there is none.
    std::optional<std::vector<std::byte>> get_feature(std::uint8_t id);

    // False if there is no such report.
    bool set_feature(std::span<std::byte const> report);

    // How often it was told to go somewhere: never by us.
    std::size_t movement_count() const { return movement_count_; }

    // HID 1.11 section 6.2.2: features 1 to 6 of 63 bytes on a page of the vendor's.
    static std::vector<std::byte> report_descriptor();

private:
    enum class Initialisation { None, Begun, Done };

    bool is_ready() const { return has_place_ && initialisation_ == Initialisation::Done; }

    Initialisation initialisation_ = Initialisation::None;
    bool has_place_ = true;
    std::int16_t height_ = 0;
    std::int16_t asked_height_ = 0; // When it was asked last.
    std::size_t movement_count_ = 0;
};

} // namespace tractus::sim
