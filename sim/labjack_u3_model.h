#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::sim {

// A LabJack U3 as seen through its bulk endpoints: one command in, one reply out (U3 user's guide,
// section 5: low-level commands). It supports Feedback with the analogue input, ConfigIO, ConfigU3
// and ReadMem of the calibration. As the real device does, it answers a packet with wrong checksums
// with the two bytes B8 B8.
class LabJackU3Model {
public:
    struct Options {
        // True: a U3-HV, whose FIO0 to FIO3 are always analogue, from about -10 V to 10 V.
        bool is_high_voltage = false;
        std::uint32_t serial_number = 320012345;
        double volts_per_count = 3.7231e-05; // Calibration of the low-voltage inputs, single-ended.
        double offset_volts = 0;
        double high_volts_per_count = 0.000314; // Calibration of the high-voltage inputs.
        double high_offset_volts = -10.3;
    };

    LabJackU3Model();
    explicit LabJackU3Model(Options const& options);

    // Sets the reading of channel 0 to 15, in counts of 16 bits; the 12-bit converter uses the
    // upper 12.
    void set_counts(int channel, std::uint16_t counts);

    std::vector<std::byte> answer(std::span<std::byte const> command);

private:
    std::vector<std::byte> answer_feedback(std::span<std::byte const> data) const;
    std::vector<std::byte> answer_config_io(std::span<std::byte const> data);
    std::vector<std::byte> answer_config_u3() const;
    std::vector<std::byte> answer_read_memory(std::span<std::byte const> data) const;

    Options options_;
    std::array<std::uint16_t, 16> counts_ {};
    std::uint16_t analog_ = 0; // Analogue channels, one bit each.
};

} // namespace tractus::sim
