#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <cstdint>
#include <memory>

namespace tractus::drivers {

// A motorised standing desk with LINAK actuators, connected through their cable USB2LIN06: the desk
// itself reports its height in tenths of a millimetre. This code never moves the desk. The protocol
// was found out by users (firmware-notes/desk.md); there is no data sheet.

// Added to the desk's height in tenths of a millimetre, so that the lowest position is not at the
// end of the range, where a reading would count as out of range.
constexpr std::int32_t kLinakCountsBelow = 100;
constexpr std::int32_t kLinakFullScale
    = 10'100; // Covers 1,000 mm of travel; desks have 500 to 700 mm.

// Returns true if the ids are those of LINAK's cable.
bool is_linak_desk(DeviceInfo const&);

// Opens the cable at `info.location`, a hidraw node, and polls it 50 times a second. A report is
// the cable's reply, feature report 4 with 64 bytes. A desk that has just been powered up does not
// know its height. In that case, at opening and later, the cable is initialised as its maker's
// program does it, which tells the motors to stop.
//
// Fails with a user error if the node cannot be opened, or if the desk does not know its height
// even after the initialisation: it must then be moved to its lowest position with its own keys.
Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info);

// Opens the cable over any link in which a one-byte packet requests a feature report, and a longer
// one sets it (open_hid_feature_link()). Fails if the desk does not know its height.
Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info,
                                                      std::unique_ptr<PacketLink> link);

// Makes the decoder for the desk's reports. Decoding skips other reports, and fails with a
// device error for a reply that is truncated, lacks the height, or contains an impossible one.
std::unique_ptr<HeightDecoder> make_linak_desk_decoder();

} // namespace tractus::drivers
