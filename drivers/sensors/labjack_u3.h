#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>

namespace tractus::drivers {

// LabJack's U3, a finished USB device with a converter of 12 bits, as a height sensor (U3 user's
// guide, section 5).

struct LabJackU3Options {
    // The wiper is on AIN`channel`: 0 to 7 are FIO0 to FIO7, 8 to 15 are EIO0 to EIO7. Low-voltage
    // inputs go from 0 to 2.44 V; AIN0 to AIN3 of a U3-HV from -10 to 10 V.
    int channel = 0;
};

// "AIN3", or nothing for the defaults. Fails, as the user's fault, for anything else.
Result<LabJackU3Options> parse_labjack_u3_options(std::string_view settings);

// Whether the device is one, by its ids.
bool is_labjack_u3(DeviceInfo const&);

// Opens the U3 at `info.location` ("usb:1-2.3") through libusb, with `info.settings` as options,
// makes the channel an analog input, the other pins staying as they are, and reads it 250 times a
// second: a report is the U3's answer to its Feedback command. Model, serial number, channel, and
// the calibration constants of that input as the U3's memory has them, stand in info()'s name.
//
// Fails, as the user's fault, if it cannot be opened, and as the device's if it does not answer as
// a U3 does.
Result<std::unique_ptr<ReportSource>> open_labjack_u3(DeviceInfo info);

// Opens one over any link. Fails, as the device's fault, likewise.
Result<std::unique_ptr<ReportSource>>
open_labjack_u3(DeviceInfo info, std::unique_ptr<PacketLink> link, LabJackU3Options const& options);

// Counts of 0 to 65520: the converter's 12 bits are the upper ones of 16. Decoding fails for
// answers that are cut off, that a checksum refutes, or that report an error.
Result<std::unique_ptr<HeightDecoder>> make_labjack_u3_decoder(DeviceInfo const&);

} // namespace tractus::drivers
