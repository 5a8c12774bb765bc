#include "drivers/tablets/usb_tablet.h"

#include "drivers/file.h"
#include "drivers/usb/string_descriptor.h"

#include <array>
#include <charconv>
#include <fmt/core.h>
#include <libusb.h>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

std::string read_line(fs::path const& file)
{
    auto const text = read_file(file);
    return text ? text->substr(0, text->find('\n')) : std::string();
}

std::uint16_t read_id(fs::path const& file)
{
    auto const text = read_line(file);
    std::uint16_t id = 0;
    std::from_chars(text.data(), text.data() + text.size(), id, 16);
    return id;
}

// HID 1.11 section 7.1.1: GET_DESCRIPTOR of an interface.
Result<std::vector<std::byte>> read_report_descriptor(std::string const& usb_address,
                                                      int interface_number)
{
    constexpr std::uint8_t kFromInterface
        = std::uint8_t { LIBUSB_ENDPOINT_IN } | std::uint8_t { LIBUSB_RECIPIENT_INTERFACE };
    constexpr std::uint16_t kReportDescriptor = LIBUSB_DT_REPORT << 8;
    constexpr unsigned kTimeout_ms = 1000;
    auto device = TRY(UsbDevice::open(usb_address));
    TRY(device.claim(interface_number));
    std::array<unsigned char, 4096> buffer {}; // As much as Linux reads.
    int const size = libusb_control_transfer(
        device.handle(), kFromInterface, LIBUSB_REQUEST_GET_DESCRIPTOR, kReportDescriptor,
        static_cast<std::uint16_t>(interface_number), buffer.data(), buffer.size(), kTimeout_ms);
    if (size < 0)
        return fail(Fault::Device,
                    fmt::format("interface {} of the USB device at {} does not tell its report "
                                "descriptor: {}",
                                interface_number, usb_address, usb_error_text(size)));
    auto const bytes = std::as_bytes(std::span(buffer).first(static_cast<std::size_t>(size)));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
}

} // namespace

Result<std::string> UsbStrings::read(int index)
{
    if (address_.empty())
        return fail(Fault::User, "it is not on USB, and only there can its strings be read");
    if (!device_)
        device_ = TRY(UsbDevice::open(address_));
    auto const bytes = device_->string_bytes(static_cast<std::uint8_t>(index));
    return bytes ? string_descriptor_text(*bytes) : std::string();
}

Result<DeviceInfo> describe_usb_tablet(LibusbAddress const& address, DeviceInfo info,
                                       fs::path const& devices_folder)
{
    auto const port = print_usb_port(address.port);
    auto const folder = devices_folder / port;
    std::error_code error;
    if (!fs::exists(folder, error))
        return fail(Fault::User,
                    fmt::format("there is no USB device at {} (was it unplugged?)", port));
    info.vendor_id = read_id(folder / "idVendor");
    info.product_id = read_id(folder / "idProduct");
    info.manufacturer = read_line(folder / "manufacturer");
    info.serial_number = read_line(folder / "serial");
    info.name = read_line(folder / "product");
    info.interface_number = address.interface_number;
    info.report_descriptor = TRY(read_report_descriptor(port, address.interface_number));
    return info;
}

} // namespace tractus
