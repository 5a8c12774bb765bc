#pragma once

#include "drivers/gpio/gpio_edges.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tractus::drivers {

// A draw-wire encoder in quadrature on two GPIO lines as a height sensor. It cannot be found, only
// named: its address, "gpio:CHIP:A,B:quadrature" in DeviceInfo::location, says where it is. How to
// wire one is in firmware-notes/encoder.md.
//
// It counts from where the surface is when it is opened. Its reports have eight bytes; their time
// is that of the last edge in them, or the present while nothing moves:
//
//   ..            bit 0: edges were lost since the last report, so that the count is not true
//   ..            how many, 255 at most
//   .. ..         how many edges there are in it, the low byte first
//   .. .. .. ..   count, signed, the low byte first

// Readings come at this rate while it moves, and at that one while it rests.
constexpr Duration kEncoderPeriod = std::chrono::milliseconds(2);
constexpr Duration kEncoderRestingPeriod = std::chrono::milliseconds(10);

// A sample's counts are the reports' and this, so that it may go down from where it began.
constexpr std::int32_t kEncoderCountsBelow = 1 << 20;
constexpr std::int32_t kEncoderFullScale = (1 << 21) - 1;

// Describes the encoder at an address, whether it is there or not. Fails, as the user's fault, if
// the text is no address of one.
Result<DeviceInfo> describe_gpio_encoder(std::string const& address);

// Opens the lines that `info.location` names. Fails as open_gpio_edges() does; a read fails, as the
// device's fault, when the lines do.
Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info);

// Opens the encoder on lines that are open already, be they real or simulated. Fails, as the user's
// fault, if `info.location` is no address of an encoder.
Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info,
                                                        std::unique_ptr<GpioEdges> edges);

// Whether a device, live or from a log, is one of these.
bool is_gpio_encoder(DeviceInfo const& info);

// Decoding fails, as the device's fault, for a report of another length, a count that no string is
// long enough for, and once for each report that has lost edges; the counts after it go on from
// where the lost ones have left them.
std::unique_ptr<HeightDecoder> make_gpio_encoder_decoder();

} // namespace tractus::drivers
