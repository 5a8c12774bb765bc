#include "calib/height_check.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calib {

Result<void> check_converter(std::int32_t full_scale_counts, Rig const& rig)
{
    if (full_scale_counts != rig.full_scale_counts)
        return fail(Fault::User,
                    fmt::format("the height sensor reads up to {} and the rig was calibrated with "
                                "one up to {}: connect that one, or calibrate the height anew",
                                full_scale_counts, rig.full_scale_counts));
    return {};
}

Result<double> height_of(HeightCapture const& capture, Rig const& rig)
{
    if (auto const height = height_mm(rig.height_model, capture.counts))
        return *height;
    return fail(Fault::User,
                fmt::format("the rig has no height for the reading {:.0f} at {:g} mm: calibrate "
                            "the height anew",
                            capture.counts, capture.ruler_mm));
}

namespace {

bool was_fitted(double ruler_mm, Rig const& rig)
{
    auto const& record = rig.calibration.height;
    return record
        && std::any_of(record->captures.begin(), record->captures.end(), [&](auto const& capture) {
               return std::abs(capture.ruler_mm + record->raised_mm - ruler_mm) < kSameHeight_mm;
           });
}

} // namespace

Result<HeightCheck> check_height(std::span<HeightCapture const> captures,
                                 std::int32_t full_scale_counts, Rig const& rig)
{
    TRY(check_converter(full_scale_counts, rig));
    if (captures.empty())
        return fail(Fault::User,
                    "no height was captured: set the surface to a known height, let "
                    "it rest and capture it");
    HeightCheck check { .low_mm = captures.front().ruler_mm, .high_mm = captures.front().ruler_mm };
    double greatest_mm = 0;
    for (auto const& capture : captures) {
        double const error_mm = TRY(height_of(capture, rig)) - capture.ruler_mm;
        check.heights_mm.push_back(capture.ruler_mm);
        check.errors_mm.push_back(error_mm);
        greatest_mm = std::max(greatest_mm, std::abs(error_mm));
        check.low_mm = std::min(check.low_mm, capture.ruler_mm);
        check.high_mm = std::max(check.high_mm, capture.ruler_mm);
        if (was_fitted(capture.ruler_mm, rig))
            check.known_mm.push_back(capture.ruler_mm);
        if (capture.counts < rig.calibrated_min_counts
            || capture.counts > rig.calibrated_max_counts)
            check.outside_mm.push_back(capture.ruler_mm);
    }
    check.within_mm = std::ceil(greatest_mm * 10 - 1e-9) / 10;
    return check;
}

std::string quote(HeightCheck const& check)
{
    if (check.low_mm == check.high_mm)
        return fmt::format("within {:.1f} mm at {:g} mm", check.within_mm, check.low_mm);
    return fmt::format("within {:.1f} mm over {:g}–{:g} mm", check.within_mm, check.low_mm,
                       check.high_mm);
}

} // namespace tractus::calib
