#include "drivers/tablets/usb_tablet.h"

#include "drivers/reports/device_address.h"
#include "drivers/usb/string_descriptor.h"
#include "drivers/usb/usb_interfaces.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <libusb.h>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

// Reads the report descriptor of an interface with GET_DESCRIPTOR (HID 1.11, section 7.1.1).
Result<std::vector<std::byte>> read_report_descriptor(std::string const& usb_address,
                                                      int interface_number)
{
    constexpr std::uint8_t kFromInterface
        = std::uint8_t { LIBUSB_ENDPOINT_IN } | std::uint8_t { LIBUSB_RECIPIENT_INTERFACE };
    constexpr std::uint16_t kReportDescriptor = LIBUSB_DT_REPORT << 8;
    constexpr unsigned kTimeout_ms = 1000;
    auto device = TRY(UsbDevice::open(usb_address));
    TRY(device.claim(interface_number));
    std::array<unsigned char, 4096> buffer {}; // The size is the greatest that Linux reads.
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

std::vector<DeviceInfo> list_usb_tablets(fs::path const& devices_folder)
{
    constexpr int kHid = 3;
    std::vector<DeviceInfo> found;
    for (auto& interface : list_usb_interfaces(devices_folder)) {
        if (interface.usb_class != kHid)
            continue;
        interface.info.location
            = fmt::format("libusb:{}:{}", interface.port, interface.info.interface_number);
        found.push_back(std::move(interface.info));
    }
    return found;
}

Result<DeviceInfo> describe_usb_tablet(DeviceInfo info)
{
    auto const listed = list_usb_tablets();
    auto const found = std::find_if(listed.begin(), listed.end(), [&](DeviceInfo const& device) {
        return device.location == info.location;
    });
    if (found == listed.end())
        return fail(Fault::User,
                    fmt::format("there is no HID device at {} (was it unplugged?)", info.location));
    auto described = *found;
    described.settings = std::move(info.settings);
    auto const address = TRY(parse_device_address(info.location));
    described.report_descriptor = TRY(read_report_descriptor(
        print_usb_port(std::get<LibusbAddress>(address).port), described.interface_number));
    return described;
}

} // namespace tractus::drivers
