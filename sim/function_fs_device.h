#pragma once

#include "engine/base/result.h"
#include "sim/file_descriptor.h"
#include "sim/kernel_device.h"
#include "sim/usb_gadget.h"
#include "sim/usb_setup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <linux/aio_abi.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::sim {

// Descriptors of a function's interface, for full and for high speed: the interface and its one
// endpoint, bulk IN (USB 2.0, sections 9.6.5 and 9.6.6). Its string, number 1, is `name`.
struct UsbFunctionDescriptors {
    std::vector<std::byte> full_speed {};
    std::vector<std::byte> high_speed {};
    std::string name {};
};

// A device's answers to control requests that the kernel does not answer itself. Refused requests
// appear to the host as a stall.
struct UsbControlAnswers {
    // Returns the data of an IN request; no value refuses it. Data longer than requested is
    // truncated.
    std::function<std::optional<std::vector<std::byte>>(UsbSetup const&)> get {};
    // Handles an OUT request; `data` is what the host sent. Returning false refuses it.
    std::function<bool(UsbSetup const&, std::span<std::byte const> data)> set {};
    // Called when the host has reset the device or has gone.
    std::function<void()> reset {};
};

// A USB gadget's function with one bulk IN endpoint, made with the kernel's FunctionFS. Each report
// is one transfer.
class FunctionFsDevice final : public KernelDevice {
public:
    // Greatest number of transfers that wait for the host, as in a microcontroller's memory.
    // Further reports are lost.
    static constexpr std::size_t kMaxWaiting = 8;
    static constexpr std::size_t kMaxReportBytes = 512;

    // Adds the function to `gadget`, which must not be plugged in yet and must outlive the
    // function. Fails with a user error if the kernel refuses it.
    static Result<std::unique_ptr<FunctionFsDevice>>
    add_to(UsbGadget& gadget, UsbFunctionDescriptors const& descriptors, UsbControlAnswers answers);
    ~FunctionFsDevice() override;

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_read_; }
    bool detects_readers_by_reports() const override { return true; }
    std::uint64_t lost_count() const override { return lost_count_; }
    std::size_t waiting_count() const override { return waiting_count_; }

private:
    struct Transfer {
        bool is_busy = false;
        iocb request {};
        std::array<std::byte, kMaxReportBytes> bytes {};
    };

    FunctionFsDevice(FileDescriptor control, UsbControlAnswers answers);

    Result<void> open_endpoint(std::filesystem::path const& mount);
    void finish_transfers();
    bool serve_control();
    void answer(UsbSetup const& request);

    FileDescriptor control_;  // Control endpoint, file ep0.
    FileDescriptor endpoint_; // Bulk endpoint, file ep1.
    FileDescriptor finished_; // An eventfd, readable when a transfer has ended.
    aio_context_t context_ = 0;
    UsbControlAnswers answers_;
    std::array<Transfer, kMaxWaiting> transfers_ {};
    std::size_t waiting_count_ = 0;
    bool is_enabled_ = false; // True when the host has configured the device.
    bool is_read_ = false;
    std::uint64_t lost_count_ = 0;
};

} // namespace tractus::sim
