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

// An MCP3008 or MCP3208 converter on GPIO lines as a height sensor. It cannot be discovered, only
// named: its address "gpio:CHIP:CLK,DIN,DOUT,CS:mcp3208:CHANNEL" in DeviceInfo::location tells
// where it is (device_address.h). Wiring: firmware-notes/wiring.md.
//
// A report has four bytes; its time is the time of sampling, without latency:
//
// byte 0, bit 0: no answer, because DOUT was high where the converter sends a zero; bit 1: the
// sample was held for more than 1.2 ms, so the reading may be too low
//
// byte 1: number of conversions that were repeated for this report because they were interrupted
//
// bytes 2 and 3: counts, little-endian

// Interval between readings. The lines of a Raspberry Pi are fast enough for it.
constexpr Duration kGpioAdcPeriod = std::chrono::milliseconds(2);

// A monotonic clock and a function that waits until a time of that clock.
struct GpioClock {
    std::function<Timestamp()> now;
    std::function<void(Timestamp)> sleep_until;
};

// Describes the converter at an address, whether or not it is connected. Fails with a user error if
// the text is not the address of a converter on GPIO lines.
Result<DeviceInfo> describe_gpio_adc(std::string const& address);

// Opens the converter at `info.location` through libgpiod and takes trial readings. A conversion is
// repeated if the scheduler interrupted it for so long that the sampled charge was lost. The lines
// of a USB adapter are too slow even without interruption; such lines are used nevertheless, and
// the reports are flagged.
//
// Fails with a user error if the address is malformed or its lines are not available, and with a
// device error if nothing answers on DOUT. read() fails with a device error when the lines fail.
Result<std::unique_ptr<ReportSource>> open_gpio_adc(DeviceInfo info);

// Opens the converter on real or simulated lines that are open already, in the order of
// mcp3208_lines(). Fails like the overload above, except for opening the lines.
Result<std::unique_ptr<ReportSource>>
open_gpio_adc(DeviceInfo info, std::unique_ptr<GpioLines> lines, GpioClock clock);

// True if a device, live or from a log, is a converter on GPIO lines.
bool is_gpio_adc(DeviceInfo const& info);

// Makes the decoder of the converter's reports; requires is_gpio_adc(info). Decoding fails with a
// device error for a wrong length, a reading beyond full scale, or no answer.
std::unique_ptr<HeightDecoder> make_gpio_adc_decoder(DeviceInfo const& info);

} // namespace tractus::drivers
