#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::sim {

// A LabJack U3 as its bulk endpoints show it: one command in, one reply out (U3 user's guide,
// section 5: low-level commands). It knows Feedback with the analog input, ConfigIO, ConfigU3 and
// ReadMem of the calibration, and answers a packet whose checksums are wrong with the two bytes
// B8 B8, as the device does.
class LabJackU3Model {
public:
    struct Options {
        bool is_high_voltage = false; // U3-HV: FIO0 to FIO3 are always analog, from -10 V to 20 V.
        std::uint32_t serial_number = 320012345;
        double volts_per_count = 3.7231e-05; // Value of the low-voltage inputs, single-ended.
        double offset_volts = 0;
        double high_volts_per_count = 0.000314; // Value of the high-voltage inputs.
        double high_offset_volts = -10.3;
    };

    LabJackU3Model();
    explicit LabJackU3Model(Options const& options);

    // Makes channel `channel`, 0 to 15, read so many counts of 16 bits from now on; the converter
    // has the upper 12.
    void set_counts(int channel, std::uint16_t counts);

    std::vector<std::byte> answer(std::span<std::byte const> command);

private:
    std::vector<std::byte> answer_feedback(std::span<std::byte const> data) const;
    std::vector<std::byte> answer_config_io(std::span<std::byte const> data);
    std::vector<std::byte> answer_config_u3() const;
    std::vector<std::byte> answer_read_memory(std::span<std::byte const> data) const;

    Options options_;
    std::array<std::uint16_t, 16> counts_ {};
    std::uint16_t analog_ = 0; // One bit per channel.
};

} // namespace tractus::sim
