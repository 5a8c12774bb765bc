#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"

#include <cstddef>
#include <memory>

struct hid_device_;

namespace tractus::drivers {

// Functions of one of hidapi's two libraries. Both export the same names, so only one can be linked
// directly; see drivers/tablets/hidapi_libusb.h.
struct HidBackEnd {
    int (*write)(hid_device_*, unsigned char const* data, std::size_t size) = nullptr;
    int (*read_timeout)(hid_device_*, unsigned char* data, std::size_t size, int timeout_ms)
        = nullptr;
    void (*close)(hid_device_*) = nullptr;
    wchar_t const* (*error)(hid_device_*) = nullptr;
};

using HidHandle = std::unique_ptr<hid_device_, void (*)(hid_device_*)>;

// Adapts an open device to a packet link; see open_hid_link(). `back_end` must outlive the link.
std::unique_ptr<PacketLink> make_hid_link(HidBackEnd const& back_end, HidHandle handle,
                                          DeviceInfo info);

// Adapts a link to a report source.
std::unique_ptr<ReportSource> make_hid_source(DeviceInfo info, std::unique_ptr<PacketLink> link);

} // namespace tractus::drivers
