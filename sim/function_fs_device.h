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

// A function's interface, for full and for high speed: the descriptors of the interface itself and
// of its one endpoint, bulk IN (USB 2.0 sections 9.6.5 and 9.6.6). Its string, number 1, is `name`.
struct UsbFunctionDescriptors {
    std::vector<std::byte> full_speed {};
    std::vector<std::byte> high_speed {};
    std::string name {};
};

// Answers of a device to control requests that the kernel does not answer itself. It refuses what
// it does not know, and the host sees a stall.
struct UsbControlAnswers {
    // No value refuses. What is longer than the host asked for is cut.
    std::function<std::optional<std::vector<std::byte>>(UsbSetup const&)> get {};
    // `data` is what the host sends along; false refuses.
    std::function<bool(UsbSetup const&, std::span<std::byte const> data)> set {};
    // The host has reset us, or is gone.
    std::function<void()> reset {};
};

// A function of a USB gadget with one bulk endpoint, IN: each report is a transfer.
// Made with the kernel's FunctionFS.
class FunctionFsDevice final : public KernelDevice {
public:
    // Transfers that wait for the host to ask for them, as in a microcontroller's memory; a report
    // that finds no place is lost.
    static constexpr std::size_t kMaxWaiting = 8;
    static constexpr std::size_t kMaxReportBytes = 512;

    // Adds the function to `gadget`, which must not be plugged in yet and must outlive it. Fails,
    // as the user's fault, if the kernel does not let it.
    static Result<std::unique_ptr<FunctionFsDevice>>
    add_to(UsbGadget& gadget, UsbFunctionDescriptors const& descriptors, UsbControlAnswers answers);
    ~FunctionFsDevice() override;

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_read_; }
    bool tells_readers_by_reports() const override { return true; }
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

    FileDescriptor control_;  // ep0
    FileDescriptor endpoint_; // ep1
    FileDescriptor finished_; // An eventfd, ready when a transfer has ended.
    aio_context_t context_ = 0;
    UsbControlAnswers answers_;
    std::array<Transfer, kMaxWaiting> transfers_ {};
    std::size_t waiting_count_ = 0;
    bool is_enabled_ = false; // The host has configured us.
    bool is_read_ = false;
    std::uint64_t lost_count_ = 0;
};

} // namespace tractus::sim
