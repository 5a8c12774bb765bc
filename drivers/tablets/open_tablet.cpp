#include "drivers/tablets/open_tablet.h"

#include "drivers/links/hid_source.h"
#include "drivers/reports/device_address.h"
#include "drivers/tablets/hidapi_libusb.h"
#include "drivers/tablets/hidraw_port.h"
#include "drivers/tablets/mode_switch.h"
#include "drivers/tablets/usb_tablet.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

namespace {

// Communicates with the open interface, and requests string descriptors from the device.
class LibusbPort final : public TabletPort {
public:
    LibusbPort(LibusbHid& hid, std::string usb_address)
        : hid_(hid)
        , strings_(std::move(usb_address))
    {
    }

    Result<void> send_feature(std::span<std::byte const> report) override
    {
        return hid_.send_feature(report);
    }
    Result<void> send_output(std::span<std::byte const> report) override
    {
        return hid_.send_output(report);
    }
    Result<std::string> read_string(int index) override { return strings_.read(index); }

private:
    LibusbHid& hid_;
    UsbStrings strings_;
};

Result<std::unique_ptr<ReportSource>> open_through_libusb(DeviceInfo info)
{
    auto const address = TRY(parse_device_address(info.location));
    auto const* const libusb = std::get_if<LibusbAddress>(&address);
    if (!libusb)
        return fail(Fault::User,
                    fmt::format("\"{}\" is no address of a tablet (\"/dev/hidraw3\", "
                                "\"libusb:1-2.3:0\")",
                                info.location));
    info = TRY(describe_usb_tablet(std::move(info)));
    auto hid = TRY(LibusbHid::open(*libusb, info));
    LibusbPort port(hid, print_usb_port(libusb->port));
    switch_to_full_mode(info, port, SwitchedBy::Nobody);
    return std::move(hid).into_source(std::move(info));
}

Result<std::unique_ptr<ReportSource>> open_through_hidraw(DeviceInfo info)
{
    HidrawPort port(info, enumerate_hid());
    if (port.is_open())
        switch_to_full_mode(info, port, port.switched_by());
    return open_hid(std::move(info)); // Reports the reason if the node cannot be opened.
}

} // namespace

Result<std::unique_ptr<ReportSource>> open_tablet(DeviceInfo info)
{
    if (info.location.starts_with("/dev/"))
        return open_through_hidraw(std::move(info));
    return open_through_libusb(std::move(info));
}

} // namespace tractus::drivers
