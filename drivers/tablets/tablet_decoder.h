#pragma once

#include "drivers/pens/family_decoder.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "drivers/tablets/tablet_lookup.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Returns the size and ranges of a tablet, from its USB string 200 or 100 if possible, otherwise
// from the table. The size counts as assumed if the table marks it as doubtful or if other tablets
// would match as well.
TabletShape tablet_shape(DeviceInfo const& info, TabletMatch const& match);

// Makes the decoder for a tablet in the table. One node may send both reports in its maker's own
// format and reports that its descriptor describes, for instance before and after the tablet was
// switched:
//
// - a report that the descriptor describes as a pen's is decoded by the descriptor, since Linux's
//   drivers rewrite descriptor and reports together; but if strings that switch the tablet were
//   read and no driver has rewritten the descriptor, the family's reports are decoded in the
//   family's format;
// - a report that the descriptor does not describe, or declares as vendor-defined, is decoded in
//   the family's format;
// - all other reports (mice, keys, touches) are not about a pen.
//
// When the pen changes from one kind of report to the other, it is first reported as leaving.
//
// Fails like make_descriptor_decoder() if the node carries no pen data and with a user error if
// its format is not known.
Result<std::unique_ptr<PenDecoder>> make_tablet_decoder(DeviceInfo const& info,
                                                        TabletMatch const& match);

} // namespace tractus::drivers
