#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "sim/file_descriptor.h"
#include "sim/kernel_device.h"
#include "sim/usb_gadget.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tractus::sim {

// A HID function of a USB gadget (the kernel's f_hid): a pen, say. At high speed the host asks for
// a report each millisecond. What it sends to the device is taken and forgotten.
class GadgetHid final : public KernelDevice {
public:
    // Reports wait here for the host to ask for them, as in a tablet's own memory.
    static constexpr std::size_t kMaxWaiting = 64;

    // Adds to `gadget`, which must not be plugged in yet and must outlive the function, a HID
    // interface with the report descriptor of `info`. `name` tells the gadget's functions apart.
    // Fails if the report descriptor is missing or broken, or configfs refuses it.
    static Result<std::unique_ptr<GadgetHid>> add_to(UsbGadget& gadget, std::string const& name,
                                                     drivers::DeviceInfo const& info);

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;

    // Drops the report if the gadget is unplugged, and the oldest if kMaxWaiting wait already.
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_read_; }
    bool tells_readers_by_reports() const override { return true; }
    std::uint64_t lost_count() const override { return lost_count_; }
    std::size_t waiting_count() const override { return waiting_.size() + (in_flight_ ? 1 : 0); }

private:
    explicit GadgetHid(std::filesystem::path folder);

    bool open();
    bool is_taken() const;
    void discard_output();
    void write_next();
    void lose(std::size_t count);
    void leave();

    std::filesystem::path folder_; // The function's, in configfs.
    FileDescriptor file_;          // Empty while the gadget is unplugged.
    std::deque<std::vector<std::byte>> waiting_;
    bool in_flight_ = false;        // The kernel has a report that the host has not asked for yet.
    std::uint64_t taken_count_ = 0; // Since the gadget was plugged in.
    bool is_read_ = false;
    bool was_read_ = false; // Ever: before, nothing counts as lost.
    std::uint64_t lost_count_ = 0;
};

} // namespace tractus::sim
