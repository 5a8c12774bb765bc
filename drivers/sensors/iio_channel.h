#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// A channel of the kernel's industrial I/O (Documentation/ABI/testing/sysfs-bus-iio) as a height
// sensor: any converter or distance sensor with a Linux driver, such as the ADS1115 or the VL53L0X
// (firmware-notes/iio.md). Its address is "iio:DEVICE:CHANNEL", where DEVICE is "device0" or the
// device's own name, and CHANNEL is the part between in_ and _raw: "iio:ads1015:voltage0". It is
// read only if the user names its address.
//
// A report is the text of the channel's file, a value in the converter's counts. Settings may
// follow the @ of the address. One is the greatest value, such as max=4095 (default: from the
// channel's type file, otherwise 32767). The other is the time between two readings, 2000us by
// default; slower converters take longer.

constexpr char const* kIioFolder = "/sys/bus/iio/devices";

// Lists the channels that can be a height sensor: voltages, distances, angles and positions.
std::vector<DeviceInfo> list_iio_channels(std::filesystem::path const& folder = kIioFolder);

// Describes the channel at an address. Fails with a user error if there is none.
Result<DeviceInfo> describe_iio_channel(std::string const& address,
                                        std::filesystem::path const& folder = kIioFolder);

// Opens the channel at `info.location`. Fails with a user error if there is none, it cannot be
// read, or the settings are invalid. A read fails with a device error when the device is gone
// or has not answered for a second.
Result<std::unique_ptr<ReportSource>>
open_iio_channel(DeviceInfo info, std::filesystem::path const& folder = kIioFolder);

// True if a device, live or from a log, is an industrial I/O channel.
bool is_iio_channel(DeviceInfo const& info);

// Makes the decoder of a channel's reports; `info` must satisfy is_iio_channel(). Fails with a
// user error if the settings in a log are invalid.
Result<std::unique_ptr<HeightDecoder>> make_iio_channel_decoder(DeviceInfo const& info);

} // namespace tractus::drivers
