#include "calib/zeroing.h"

#include "calib/height_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr std::array<std::string_view, 2> kCauseNames { "slipped", "moved" };
constexpr double kSignificance = 4; // A difference beyond this many ruler errors is significant.

// The rig corrected for one cause, and how well the captures fit the corrected rig.
struct Trial {
    Rig rig {};
    double sum_of_squares_mm2 = 0;
};

double in_thousandths(double value)
{
    return std::round(value * 1000) / 1000;
}

Result<double> misfit_mm2(Captures captures, Rig const& rig)
{
    double sum = 0;
    for (auto const& capture : captures)
        sum += std::pow(TRY(height_of(capture, rig)) - capture.ruler_mm, 2);
    return sum;
}

// Corrects the rig for a moved zero. The correction is rounded to micrometres, so that the rig file
// stays readable.
Result<Trial> after_move(Rig rig, Captures captures)
{
    double rise_mm = 0;
    for (auto const& capture : captures)
        rise_mm += (capture.ruler_mm - TRY(height_of(capture, rig)))
            / static_cast<double>(captures.size());
    rise_mm = in_thousandths(rise_mm);
    rig.height_model = raised(rig.height_model, rise_mm);
    if (auto& record = rig.calibration.height) {
        record->raised_mm += rise_mm;
        record->heights_mm.array() += rise_mm;
    }
    double const sum = TRY(misfit_mm2(captures, rig));
    return Trial { std::move(rig), sum };
}

// Returns the shift of the readings in counts. A capture's weight is the squared height of one
// count there: the greater that height, the better the capture determines the shift.
Result<double> shift_of(Rig const& rig, Captures captures)
{
    double sum = 0;
    double weights = 0;
    for (auto const& capture : captures) {
        auto const counts = counts_at_height(rig.height_model, capture.ruler_mm);
        if (!counts)
            return fail(Fault::User,
                        fmt::format("the rig's sensor does not reach down to {:g} mm: zero it at "
                                    "another height, or calibrate the height anew",
                                    capture.ruler_mm));
        double const worth = mm_per_count_at(rig.height_model, *counts).value_or(0);
        sum += worth * worth * (capture.counts - *counts);
        weights += worth * worth;
    }
    return weights > 0 ? in_thousandths(sum / weights) : 0;
}

// Corrects the rig for a slipped string. The surface's range of heights stays, but now corresponds
// to other readings.
Result<Trial> after_slip(Rig rig, Captures captures)
{
    double const shift_counts = TRY(shift_of(rig, captures));
    rig.height_model = shifted(rig.height_model, shift_counts);
    rig.calibrated_min_counts += shift_counts;
    rig.calibrated_max_counts += shift_counts;
    if (auto& record = rig.calibration.height)
        record->shifted_counts += shift_counts;
    double const sum = TRY(misfit_mm2(captures, rig));
    return Trial { std::move(rig), sum };
}

double most_between_mm(Rig const& a, Rig const& b)
{
    constexpr int kSteps = 50;
    double most = 0;
    for (int i = 0; i <= kSteps; ++i) {
        double const counts = a.calibrated_min_counts
            + (a.calibrated_max_counts - a.calibrated_min_counts) * i / kSteps;
        auto const one = height_mm(a.height_model, counts);
        auto const other = height_mm(b.height_model, counts);
        if (one && other)
            most = std::max(most, std::abs(*one - *other));
    }
    return most;
}

} // namespace

std::string_view name_of(ZeroCause cause)
{
    return kCauseNames[static_cast<std::size_t>(cause)];
}

std::optional<ZeroCause> parse_zero_cause(std::string_view name)
{
    auto const found = std::find(kCauseNames.begin(), kCauseNames.end(), name);
    if (found == kCauseNames.end())
        return std::nullopt;
    return static_cast<ZeroCause>(found - kCauseNames.begin());
}

Result<Zeroing> zeroed(Rig const& rig, Captures captures, std::int32_t full_scale_counts,
                       std::optional<ZeroCause> cause)
{
    TRY(check_converter(full_scale_counts, rig));
    if (captures.empty())
        return fail(Fault::User,
                    "nothing was captured: set the surface to a known height, let it rest and "
                    "capture it");
    auto moved = TRY(after_move(rig, captures));
    auto const slip = after_slip(rig, captures);
    if (!slip && cause == ZeroCause::Slipped)
        return tl::unexpected(slip.error());
    if (!slip)
        return Zeroing { .rig = std::move(moved.rig), .cause = ZeroCause::Moved, .is_told = true };
    double const ruler_error_mm
        = rig.calibration.height ? rig.calibration.height->ruler_error_mm : 0.3;
    double const gain = moved.sum_of_squares_mm2 - slip->sum_of_squares_mm2;
    bool const captures_tell
        = std::abs(gain) >= kSignificance * kSignificance * ruler_error_mm * ruler_error_mm;
    auto const chosen
        = cause.value_or(captures_tell && gain < 0 ? ZeroCause::Moved : ZeroCause::Slipped);
    double const difference_if_other_cause_mm = most_between_mm(slip->rig, moved.rig);
    return Zeroing { .rig = chosen == ZeroCause::Slipped ? slip->rig : std::move(moved.rig),
                     .cause = chosen,
                     .difference_if_other_cause_mm = difference_if_other_cause_mm,
                     .is_told = cause || captures_tell };
}

} // namespace tractus::calib
