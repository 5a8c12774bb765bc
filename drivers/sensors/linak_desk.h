#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <cstdint>
#include <memory>

namespace tractus::drivers {

// A motorised standing desk with LINAK's actuators, through their cable USB2LIN06: the desk itself
// tells how high it is, in tenths of a millimetre. Nothing here ever moves it. What the cable says
// was found by its users (firmware-notes/desk.md); there is no data sheet.

// A reading's counts are tenths of a millimetre above a place 10 mm below the desk's lowest
// position, so that this is not an end of the range, where a reading would tell nothing.
constexpr std::int32_t kLinakCountsBelow = 100;
constexpr std::int32_t kLinakFullScale = 10'100; // 1,000 mm of travel; desks have 500 to 700.

// Whether the device is such a cable, by its ids.
bool is_linak_desk(DeviceInfo const&);

// Opens the cable at `info.location`, a hidraw node, and asks it 50 times a second. A report is the
// cable's answer, feature report 4 of 64 bytes. A desk that has just got its power does not know
// yet how high it is: then the cable is initialised as its maker's program does it, which tells the
// motors to stop, at opening and again whenever that is so.
//
// Fails, as the user's fault, if the node cannot be opened, or if the desk does not know its height
// though it was initialised: it has to be set to its lowest position by its own keys.
Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info);

// Opens one over any link on which a single byte asks for that feature report, and more bytes set
// one (open_hid_feature_link). Fails if the desk does not know its height, likewise.
Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info,
                                                      std::unique_ptr<PacketLink> link);

// Decoding passes over other reports, and fails, as the device's fault, for an answer that is cut
// off, that does not know the height, or that tells an impossible one.
std::unique_ptr<HeightDecoder> make_linak_desk_decoder();

} // namespace tractus::drivers
