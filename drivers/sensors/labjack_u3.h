#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>

namespace tractus::drivers {

// LabJack's U3, a ready-made USB device with a 12-bit converter, as a height sensor (U3 user's
// guide, section 5).

struct LabJackU3Options {
    // Number of the analogue input to which the potentiometer's wiper is connected, as in AIN3: 0
    // to 7 are FIO0 to FIO7, 8 to 15 are EIO0 to EIO7. Low-voltage inputs range from 0 to 2.44 V,
    // AIN0 to AIN3 of a U3-HV from -10 to 10 V.
    int channel = 0;
};

// Parses "AIN3", or an empty text for the defaults. Fails with a user error for anything else.
Result<LabJackU3Options> parse_labjack_u3_options(std::string_view settings);

// True if the ids are those of a U3.
bool is_labjack_u3(DeviceInfo const&);

// Opens the U3 at `info.location` ("usb:1-2.3") through libusb with the options in `info.settings`,
// makes the channel an analogue input, leaving the other pins unchanged, and reads it 250 times a
// second. A report is the U3's reply to its Feedback command. The name in info() contains the
// model, the serial number, the channel, and the calibration constants of that input from the U3's
// memory.
//
// Fails with a user error if the device cannot be opened, and with a device error if it does not
// reply as a U3.
Result<std::unique_ptr<ReportSource>> open_labjack_u3(DeviceInfo info);

// Opens a U3 over any link. Fails with a device error if it does not reply as a U3.
Result<std::unique_ptr<ReportSource>>
open_labjack_u3(DeviceInfo info, std::unique_ptr<PacketLink> link, LabJackU3Options const& options);

// Makes the decoder for a U3's reports, with counts of 0 to 65520: the converter's 12 bits are the
// upper ones of 16. Decoding fails for replies that are truncated, have a wrong checksum, or report
// an error.
Result<std::unique_ptr<HeightDecoder>> make_labjack_u3_decoder(DeviceInfo const&);

} // namespace tractus::drivers
