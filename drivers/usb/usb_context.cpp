#include "drivers/usb/usb_context.h"

#include "drivers/reports/device_address.h"
#include "drivers/usb/string_descriptor.h"
#include "engine/base/check.h"

#include <array>
#include <fmt/core.h>
#include <libusb.h>
#include <span>
#include <utility>

namespace tractus::drivers {

void CloseUsbContext::operator()(libusb_context* context) const
{
    libusb_exit(context);
}

Result<UsbContext> make_usb_context()
{
    libusb_context* context = nullptr;
    if (int const code = libusb_init(&context); code != LIBUSB_SUCCESS)
        return fail(
            Fault::User,
            fmt::format("cannot use USB: {} (is /dev/bus/usb there?)", usb_error_text(code)));
    return UsbContext(context);
}

std::string usb_address(libusb_device* device)
{
    constexpr int kMaxDepth = 7; // USB 3.2, section 10: maximum number of hubs in a row.
    std::array<std::uint8_t, kMaxDepth> ports {};
    int const depth = libusb_get_port_numbers(device, ports.data(), kMaxDepth);
    auto address = fmt::format("{}-", libusb_get_bus_number(device));
    if (depth <= 0)
        return address + "0";
    for (int i = 0; i < depth; ++i)
        address += fmt::format("{}{}", i == 0 ? "" : ".", ports[static_cast<std::size_t>(i)]);
    return address;
}

std::string usb_error_text(int code)
{
    return libusb_strerror(static_cast<libusb_error>(code));
}

namespace {

// The list of a context's devices, which stay referenced during its lifetime.
class DeviceList {
public:
    explicit DeviceList(libusb_context* context)
    {
        count_ = libusb_get_device_list(context, &list_);
    }
    ~DeviceList()
    {
        if (count_ >= 0)
            libusb_free_device_list(list_, 1);
    }
    DeviceList(DeviceList const&) = delete;
    DeviceList& operator=(DeviceList const&) = delete;

    libusb_device* find(std::string_view address) const
    {
        for (ssize_t i = 0; i < count_; ++i)
            if (usb_address(list_[i]) == address)
                return list_[i];
        return nullptr;
    }

private:
    libusb_device** list_ = nullptr;
    ssize_t count_ = 0;
};

std::string advice(int code)
{
    return code == LIBUSB_ERROR_ACCESS
        ? "permission denied (is drivers/70-tractus.rules in /etc/udev/rules.d?)"
        : usb_error_text(code);
}

} // namespace

Result<UsbDevice> UsbDevice::open(std::string_view address)
{
    auto context = TRY(make_usb_context());
    DeviceList const devices(context.get());
    auto* const device = devices.find(address);
    if (device == nullptr)
        return fail(Fault::User,
                    fmt::format("there is no USB device at {} (was it unplugged?)", address));
    libusb_device_handle* handle = nullptr;
    if (int const code = libusb_open(device, &handle); code != LIBUSB_SUCCESS)
        return fail(Fault::User,
                    fmt::format("cannot open the USB device at {}: {}", address, advice(code)));
    return UsbDevice(std::move(context), handle, std::string(address));
}

UsbDevice::UsbDevice(UsbContext context, libusb_device_handle* handle, std::string address)
    : context_(std::move(context))
    , handle_(handle)
    , address_(std::move(address))
{
}

UsbDevice::UsbDevice(UsbDevice&& other) noexcept
    : context_(std::move(other.context_))
    , handle_(std::exchange(other.handle_, nullptr))
    , address_(std::move(other.address_))
    , claimed_(std::move(other.claimed_))
{
}

UsbDevice& UsbDevice::operator=(UsbDevice&& other) noexcept
{
    if (this != &other) {
        close();
        context_ = std::move(other.context_);
        handle_ = std::exchange(other.handle_, nullptr);
        address_ = std::move(other.address_);
        claimed_ = std::move(other.claimed_);
    }
    return *this;
}

UsbDevice::~UsbDevice()
{
    close();
}

void UsbDevice::close()
{
    if (handle_ == nullptr)
        return;
    for (int const interface_number : claimed_)
        libusb_release_interface(
            handle_, interface_number); // Fails for an unplugged device, which does not matter.
    libusb_close(handle_);
    handle_ = nullptr;
}

Result<void> UsbDevice::claim(int interface_number)
{
    CHECK(handle_ != nullptr);
    libusb_set_auto_detach_kernel_driver(
        handle_, 1); // Fails where the system cannot detach kernel drivers, which does not matter.
    if (int const code = libusb_claim_interface(handle_, interface_number); code != LIBUSB_SUCCESS)
        return fail(Fault::User,
                    fmt::format("cannot take interface {} of the USB device at {}: {} (does "
                                "another program use it?)",
                                interface_number, address_, usb_error_text(code)));
    claimed_.push_back(interface_number);
    return {};
}

Result<std::vector<std::byte>> UsbDevice::string_bytes(std::uint8_t index) const
{
    CHECK(handle_ != nullptr);
    constexpr std::uint16_t kUsEnglish = 0x0409;
    std::array<unsigned char, 255> buffer {}; // The maximum that bLength can express.
    int const size = libusb_get_string_descriptor(handle_, index, kUsEnglish, buffer.data(),
                                                  static_cast<int>(buffer.size()));
    if (size < 2)
        return fail(Fault::Device,
                    fmt::format("the USB device at {} does not tell its string {}: {}", address_,
                                index, size < 0 ? usb_error_text(size) : "too short"));
    auto const bytes = std::as_bytes(std::span(buffer).first(static_cast<std::size_t>(size)));
    return std::vector<std::byte>(bytes.begin() + 2, bytes.end());
}

Result<std::string> UsbDevice::string(std::uint8_t index) const
{
    return string_descriptor_text(TRY(string_bytes(index)));
}

Result<UsbDevice> open_usb_device(DeviceInfo const& info)
{
    auto const address = TRY(parse_device_address(info.location));
    auto const* const usb = std::get_if<UsbAddress>(&address);
    if (usb == nullptr)
        return fail(Fault::User,
                    fmt::format("{} at {} is no USB device by its port: expected usb:BUS-PORTS",
                                info.name, info.location));
    return UsbDevice::open(print_usb_port(usb->port));
}

} // namespace tractus::drivers
