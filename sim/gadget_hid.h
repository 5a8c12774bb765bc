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

// A HID function of a USB gadget (the kernel's f_hid), such as a pen. At high speed the host
// requests a report each millisecond. Data sent to the device is read and discarded.
class GadgetHid final : public KernelDevice {
public:
    // Greatest number of reports that wait for the host, as in a tablet's own memory.
    static constexpr std::size_t kMaxWaiting = 64;

    // Adds a HID interface with the report descriptor of `info` to `gadget`, which must not be
    // plugged in yet and must outlive the function. `name` distinguishes the gadget's functions.
    // Fails if the report descriptor is missing or invalid, or configfs refuses it.
    static Result<std::unique_ptr<GadgetHid>> add_to(UsbGadget& gadget, std::string const& name,
                                                     drivers::DeviceInfo const& info);

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;

    // Sends a report. It is dropped if the gadget is unplugged; if kMaxWaiting reports are waiting,
    // the oldest is dropped.
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_read_; }
    bool detects_readers_by_reports() const override { return true; }
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

    std::filesystem::path folder_; // Folder of the function in configfs.
    FileDescriptor file_;          // Node of the function; empty while the gadget is unplugged.
    std::deque<std::vector<std::byte>> waiting_;
    // True while the kernel has a report that the host has not requested yet.
    bool in_flight_ = false;
    std::uint64_t taken_count_ = 0; // Number of reports taken since the gadget was plugged in.
    bool is_read_ = false;
    // True once a report has been read; earlier reports do not count as lost.
    bool was_read_ = false;
    std::uint64_t lost_count_ = 0;
};

} // namespace tractus::sim
