#pragma once

#include "calib/height_capture.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tractus::calib {

// Why a rig's heights are off, when its scale is still right. A string that hangs plumb cannot tell
// the two apart, and need not; one that runs aslant has another curve after each.
enum class ZeroCause {
    Slipped, // The string, on its spool or in its clamp: each height reads so many counts more.
    Moved,   // The table, the spool's stand or the ruler: each reading is so much higher.
};

// "slipped" or "moved".
std::string_view name_of(ZeroCause cause);
std::optional<ZeroCause> parse_zero_cause(std::string_view name);

struct Zeroing {
    Rig rig {};
    ZeroCause cause = ZeroCause::Slipped;

    // How much the heights of the calibrated range would differ at most, had it been the other
    // cause; 0 where both are the same.
    double at_stake_mm = 0;

    // Whether the cause was asked for or told by the captures; otherwise it is the usual one.
    bool is_told = false;
};

// The rig zeroed anew by captures at known heights: its scale and shape stay. Without a cause, the
// captures tell it if they lie far enough apart: if by one cause they fit better than by the other
// by 4 ruler errors or more. Otherwise the string has slipped, which is what strings do.
//
// Fails, as the user's fault, for no capture at all, another converter than the rig's, and heights
// or readings that the rig's model does not reach.
Result<Zeroing> zeroed(Rig const& rig, std::span<HeightCapture const> captures,
                       std::int32_t full_scale_counts, std::optional<ZeroCause> cause = {});

} // namespace tractus::calib
