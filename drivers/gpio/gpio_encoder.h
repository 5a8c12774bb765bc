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

// A quadrature draw-wire encoder on two GPIO lines as a height sensor. It cannot be discovered,
// only named: its address "gpio:CHIP:A,B:quadrature" in DeviceInfo::location tells where it is.
// Wiring: firmware-notes/encoder.md.
//
// Counts are relative to the height at opening. A report has eight bytes; its time is that of its
// last edge or, while nothing moves, the present time:
//
// byte 0, bit 0: edges were lost since the last report, so the count is wrong
//
// byte 1: number of lost edges, at most 255
//
// bytes 2 and 3: number of edges in this report, little-endian
//
// bytes 4 to 7: count, signed, little-endian

// Report intervals while the encoder moves and while it rests.
constexpr Duration kEncoderPeriod = std::chrono::milliseconds(2);
constexpr Duration kEncoderRestingPeriod = std::chrono::milliseconds(10);

// Offset added to the reports' counts, so that samples stay positive below the starting height.
constexpr std::int32_t kEncoderCountsBelow = 1 << 20;
constexpr std::int32_t kEncoderFullScale = (1 << 21) - 1;

// Describes the encoder at an address, whether or not it is connected. Fails with a user error if
// the text is not the address of an encoder.
Result<DeviceInfo> describe_gpio_encoder(std::string const& address);

// Opens the lines named by `info.location`. Fails like open_gpio_edges(); read() fails with a
// device error when the lines fail.
Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info);

// Opens the encoder on real or simulated lines that are open already. Fails with a user error if
// `info.location` is not the address of an encoder.
Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info,
                                                        std::unique_ptr<GpioEdges> edges);

// True if a device, live or from a log, is a quadrature encoder on GPIO lines.
bool is_gpio_encoder(DeviceInfo const& info);

// Makes the decoder of an encoder's reports. Decoding fails with a device error for a wrong length,
// for a count beyond the length of any wire, and once for each report with lost edges; later counts
// continue without the lost edges.
std::unique_ptr<HeightDecoder> make_gpio_encoder_decoder();

} // namespace tractus::drivers
