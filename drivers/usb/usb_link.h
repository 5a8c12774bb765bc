#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "engine/base/result.h"

#include <cstdint>
#include <memory>

namespace tractus::drivers {

// Two bulk endpoints of one interface.
struct UsbPipes {
    int interface_number = 0;
    std::uint8_t out_endpoint = 0; // Endpoint address, 0x01 to 0x0F.
    std::uint8_t in_endpoint = 0;  // Endpoint address, 0x81 to 0x8F.
};

// Opens the USB device at `info.location` ("usb:1-2.3") as a packet link through libusb, and claims
// the interface exclusively. A packet is one transfer of at most 512 bytes.
//
// Fails with a user error if the device is not there, may not be opened, or is in use.
Result<std::unique_ptr<PacketLink>> open_usb_link(DeviceInfo const& info, UsbPipes const& pipes);

} // namespace tractus::drivers
