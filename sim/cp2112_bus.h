#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::sim {

// A chip on an I²C bus.
struct I2cChip {
    std::uint8_t address = 0; // Seven-bit address of the chip on its bus.
    std::function<void(std::span<std::byte const> bytes)> write {};
    // Reads `size` bytes from the chip.
    std::function<std::vector<std::byte>(std::size_t size)> read {};
};

// The I²C half of a CP2112 (application note AN495, section 4): output reports start transfers and
// ask for their results. Each transfer is complete at once; a transfer to an address without a chip
// ends with "not acknowledged". The bus has one chip. No clock and no randomness are used.
class Cp2112Bus {
public:
    explicit Cp2112Bus(I2cChip chip);

    // Processes an output report, which begins with its id, and returns the input report that
    // replies to it; empty if there is no reply. Unknown and incomplete reports are ignored.
    std::vector<std::byte> output(std::span<std::byte const> report);

    // Appends the bus's reports to a report descriptor whose vendor-defined collection is open.
    static void append_reports(std::vector<std::byte>& descriptor);

private:
    void start_write(std::span<std::byte const> bytes, std::uint8_t address);
    void start_read(std::size_t size, std::uint8_t address);
    std::vector<std::byte> status() const;
    std::vector<std::byte> next_data();

    I2cChip chip_;
    bool has_started_ = false; // True after the first transfer.
    bool is_acknowledged_ = false;
    std::size_t transferred_ = 0;
    std::vector<std::byte> unread_ {}; // Bytes of the last read that the host has not fetched.
};

} // namespace tractus::sim
