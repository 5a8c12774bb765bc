#pragma once

#include "drivers/pens/family_decoder.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_decoder.h"
#include "drivers/tablets/tablet_lookup.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// The size and ranges of a tablet: what it told itself in string 200 or 100, else the table's. The
// size counts as assumed where the table doubts it or where other tablets would fit as well.
TabletShape tablet_shape(DeviceInfo const& info, TabletMatch const& match);

// The decoder for a tablet that the table knows. One node may send both its maker's own reports and
// some that its descriptor describes, before and after the tablet was switched, say:
//
// - a report that the descriptor describes as a pen's is read so, since Linux's drivers rewrite
//   descriptor and reports to fit; except after strings were read that switch the tablet, where
//   no driver has touched the descriptor: then the family's reports are read as the family's;
// - a report of which the descriptor says nothing, or only that it is the maker's own, is read as
//   the family's;
// - all others, mice, keys and touches, are no pen's.
//
// When the pen goes on in reports of the other kind, it leaves first.
//
// Fails as make_descriptor_decoder does if the node carries no pen, and, as the user's fault, if it
// would carry one in a format that is not known.
Result<std::unique_ptr<PenDecoder>> make_tablet_decoder(DeviceInfo const& info,
                                                        TabletMatch const& match);

} // namespace tractus::drivers
