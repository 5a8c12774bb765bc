#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>

namespace tractus::drivers {

// An MCP3008 or MCP3208 on GPIO lines as a height sensor. It cannot be found, only named: its
// address, "gpio:CHIP:CLK,DIN,DOUT,CS:mcp3208:CHANNEL" in DeviceInfo::location, says where it is
// (device_address.h). How to wire one is in firmware-notes/wiring.md.
//
// Its reports have four bytes, and their time is that of the sampling, without latency:
//
//   ..      bit 0: nothing answered, DOUT was high where the converter sends a zero
//           bit 1: the reading was held for more than 1.2 ms and may be too low
//   ..      how many conversions were interrupted for too long and repeated before this one
//   .. ..   counts, the low byte first

// Readings come at this rate where the lines are quick enough, as a Raspberry Pi's are.
constexpr Duration kGpioAdcPeriod = std::chrono::milliseconds(2);

// A monotonic clock and how to wait by it.
struct GpioClock {
    std::function<Timestamp()> now;
    std::function<void(Timestamp)> sleep_until;
};

// Describes the converter at an address, whether it is there or not. Fails, as the user's fault, if
// the text is no address of such a converter.
Result<DeviceInfo> describe_gpio_adc(std::string const& address);

// Opens the converter at `info.location` through libgpiod and reads it a few times. A conversion
// that the scheduler interrupted for so long that the converter forgot what it had sampled is
// repeated. Lines that are too slow for the converter at their best (those of a USB adapter) are
// used all the same, and the reports say so.
//
// Fails, as the user's fault, if the address is none or its lines cannot be had, and as the
// device's if nothing answers on DOUT. A read fails, as the device's fault, when the lines do.
Result<std::unique_ptr<ReportSource>> open_gpio_adc(DeviceInfo info);

// Opens the converter on lines that are open already, those of mcp3208_lines, be they real or
// simulated. Fails likewise.
Result<std::unique_ptr<ReportSource>>
open_gpio_adc(DeviceInfo info, std::unique_ptr<GpioLines> lines, GpioClock clock);

// Whether a device, live or from a log, is one of these.
bool is_gpio_adc(DeviceInfo const& info);

// The decoder of its reports; `info` must be one of these. Decoding fails, as the device's fault,
// for a report of another length, a reading beyond full scale, and when nothing answered.
std::unique_ptr<HeightDecoder> make_gpio_adc_decoder(DeviceInfo const& info);

} // namespace tractus::drivers
