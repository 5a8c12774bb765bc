#pragma once

#include "calib/height_capture.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tractus::calib {

// Reason why a rig's heights are off although its scale is right. For a vertical string both have
// the same effect; with a string at an angle, the curve differs.
enum class ZeroCause {
    // The string slipped on its spool or in its clamp: each height has a reading shifted by a
    // constant.
    Slipped,
    // The table, the spool's stand or the ruler was moved, so every height is shifted by the same
    // amount.
    Moved,
};

// Returns "slipped" or "moved".
std::string_view name_of(ZeroCause cause);
std::optional<ZeroCause> parse_zero_cause(std::string_view name);

struct Zeroing {
    Rig rig {};
    ZeroCause cause = ZeroCause::Slipped;

    // Greatest difference, within the calibrated range, from the heights that the other cause would
    // give; 0 if both have the same effect.
    double difference_if_other_cause_mm = 0;

    // True if the cause was requested or determined from the captures; false if the usual cause, a
    // slip, was assumed.
    bool is_told = false;
};

// Zeroes the rig again with captures at known heights; its scale and shape stay. Without a given
// cause, the captures determine it if they lie far enough apart: one cause must fit better than the
// other by at least 4 ruler errors. Otherwise the string is assumed to have slipped, which is the
// usual cause.
//
// Fails with a user error for no captures, for another converter than the rig's, and for
// heights or readings outside the rig's model.
Result<Zeroing> zeroed(Rig const& rig, std::span<HeightCapture const> captures,
                       std::int32_t full_scale_counts, std::optional<ZeroCause> cause = {});

} // namespace tractus::calib
