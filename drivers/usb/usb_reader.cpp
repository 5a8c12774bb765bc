#include "drivers/usb/usb_reader.h"

#include "drivers/reports/clock.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <deque>
#include <fmt/core.h>
#include <libusb.h>
#include <utility>

namespace tractus::drivers {

using namespace std::chrono_literals;

namespace {

constexpr std::size_t kTransfers = 8;
// Size of a transfer, a multiple of the packet size at every speed.
constexpr std::size_t kTransferBytes = sizeof(RawReport::storage);
constexpr Duration kCancelLimit = 1s;

struct FreeTransfer {
    void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
};

class Reader final : public UsbReader {
public:
    Reader(UsbDevice const& device, std::string who)
        : device_(device)
        , who_(std::move(who))
    {
    }
    ~Reader() override;

    Result<void> submit(std::uint8_t endpoint);
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    struct Transfer {
        std::unique_ptr<libusb_transfer, FreeTransfer> handle {};
        std::array<unsigned char, kTransferBytes> bytes {};
        bool is_under_way = false;
        Reader* reader = nullptr; // Null after the reader was destroyed before the transfer ended.
    };

    static void LIBUSB_CALL ended(libusb_transfer* transfer);
    void finish(Transfer& transfer);
    void handle_events(Duration timeout);
    bool is_any_under_way() const;

    UsbDevice const& device_;
    std::string who_;
    std::array<std::unique_ptr<Transfer>, kTransfers> transfers_ {};
    std::deque<RawReport> ready_;
    // Reason why no more transfers will be received; empty while there is none.
    std::string failure_;
    bool is_stopping_ = false;
};

Result<void> Reader::submit(std::uint8_t endpoint)
{
    for (auto& place : transfers_) {
        place = std::make_unique<Transfer>();
        place->reader = this;
        place->handle.reset(libusb_alloc_transfer(0));
        auto* const handle = place->handle.get();
        CHECK(handle != nullptr);
        libusb_fill_bulk_transfer(handle, device_.handle(), endpoint, place->bytes.data(),
                                  static_cast<int>(place->bytes.size()), &Reader::ended,
                                  place.get(), 0);
        if (int const code = libusb_submit_transfer(handle); code != LIBUSB_SUCCESS)
            return fail(Fault::Device,
                        fmt::format("cannot read {}: {}", who_, usb_error_text(code)));
        place->is_under_way = true;
    }
    return {};
}

void LIBUSB_CALL Reader::ended(libusb_transfer* transfer)
{
    auto& own = *static_cast<Transfer*>(transfer->user_data);
    own.is_under_way = false;
    if (own.reader != nullptr)
        own.reader->finish(own);
}

// Handles a completed transfer. Any status but success ends the reading, because unplugging is
// reported at random as an error, as a missing device, or by a failure to submit the transfer
// again.
void Reader::finish(Transfer& transfer)
{
    if (transfer.handle->status != LIBUSB_TRANSFER_COMPLETED) {
        if (failure_.empty())
            failure_ = fmt::format("transfer status {}", static_cast<int>(transfer.handle->status));
        return;
    }
    RawReport report { .received = monotonic_now(),
                       .size = static_cast<std::size_t>(transfer.handle->actual_length) };
    std::memcpy(report.storage.data(), transfer.bytes.data(), report.size);
    if (report.size > 0)
        ready_.push_back(report);
    if (is_stopping_ || !failure_.empty())
        return;
    if (int const code = libusb_submit_transfer(transfer.handle.get()); code == LIBUSB_SUCCESS)
        transfer.is_under_way = true;
    else
        failure_ = usb_error_text(code);
}

void Reader::handle_events(Duration timeout)
{
    auto const us = std::chrono::ceil<std::chrono::microseconds>(std::max(timeout, Duration(0)));
    timeval limit { .tv_sec = static_cast<time_t>(us.count() / 1'000'000),
                    .tv_usec = static_cast<suseconds_t>(us.count() % 1'000'000) };
    int const code = libusb_handle_events_timeout_completed(device_.context(), &limit, nullptr);
    if (code != LIBUSB_SUCCESS && code != LIBUSB_ERROR_INTERRUPTED && failure_.empty())
        failure_ = usb_error_text(code);
}

Result<std::optional<RawReport>> Reader::read(Duration timeout)
{
    auto const end = monotonic_now() + timeout;
    handle_events(
        0ms); // Gives transfers that have already ended their time stamps as early as possible.
    while (ready_.empty() && failure_.empty()) {
        auto const left = end - monotonic_now();
        if (left <= 0ms)
            return std::optional<RawReport>();
        handle_events(left);
    }
    if (!ready_.empty()) {
        auto const report = ready_.front();
        ready_.pop_front();
        return std::optional(report);
    }
    return fail(Fault::Device, fmt::format("lost {}: {} (was it unplugged?)", who_, failure_));
}

bool Reader::is_any_under_way() const
{
    return std::any_of(transfers_.begin(), transfers_.end(),
                       [](auto const& transfer) { return transfer && transfer->is_under_way; });
}

Reader::~Reader()
{
    is_stopping_ = true;
    for (auto const& transfer : transfers_)
        if (transfer && transfer->is_under_way)
            libusb_cancel_transfer(
                transfer->handle.get()); // Fails for a device that is gone, which does not matter.
    auto const end = monotonic_now() + kCancelLimit;
    while (is_any_under_way() && monotonic_now() < end)
        handle_events(50ms);
    // Libusb may still use transfers that have not ended, so they are leaked instead of freed.
    for (auto& transfer : transfers_)
        if (transfer && transfer->is_under_way) {
            transfer->reader = nullptr;
            (void)transfer.release();
        }
}

} // namespace

Result<std::unique_ptr<UsbReader>> UsbReader::start(UsbDevice const& device, std::uint8_t endpoint,
                                                    std::string who)
{
    auto reader = std::make_unique<Reader>(device, std::move(who));
    TRY(reader->submit(endpoint));
    return reader;
}

} // namespace tractus::drivers
