#include "calib/height_fit_range.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <optional>

namespace tractus::calib {

namespace {

constexpr int kRangeSteps = 100;
constexpr double kMinKnown_mm = 3;   // Greatest acceptable standard error of a height.
constexpr double kKnownInRulers = 5; // Greatest acceptable standard error in ruler errors, if more.

// The first reading in a range at which a model has no height, or reverses its direction.
struct BrokenAt {
    double counts = 0;
    bool turns = false; // True: the direction reverses. False: there is no height.
};

std::optional<BrokenAt> find_break(HeightModel const& model, ReadingRange const& range)
{
    double const first_mm = height_mm(model, range.low).value_or(0);
    double const last_mm = height_mm(model, range.high).value_or(0);
    double const direction = last_mm > first_mm ? 1 : -1;
    std::optional<double> before_mm;
    for (int step = 0; step <= kRangeSteps; ++step) {
        double const counts = range.low + range.width() * step / kRangeSteps;
        auto const here_mm = height_mm(model, counts);
        if (!here_mm)
            return BrokenAt { .counts = counts };
        if (before_mm && !(direction * (*here_mm - *before_mm) > 0))
            return BrokenAt { .counts = counts, .turns = true };
        before_mm = here_mm;
    }
    return std::nullopt;
}

// Fails if the bend is close to the limit of rig files. Then the captures are wrong, not the track.
Result<void> check_bend(TrackBend const& bend)
{
    constexpr double kSteepest = 0.25;
    for (std::size_t i = 1; i < bend.size(); ++i)
        if (std::abs(bend[i].shift_counts - bend[i - 1].shift_counts)
            > kSteepest * (bend[i].counts - bend[i - 1].counts))
            return fail(Fault::User,
                        fmt::format("the captures near a reading of {:.0f} would take a "
                                    "potentiometer bent as none is: check what was typed and "
                                    "capture these heights again",
                                    bend[i].counts));
    return {};
}

Result<void> check_ends(HeightFit const& fit, HeightSpan const& span)
{
    for (double const end_mm : { span.low_mm, span.high_mm })
        if (!counts_at_height(fit.model, end_mm))
            return fail(
                Fault::User,
                fmt::format("the string's law ends before {:.0f} mm, which is a tenth of the "
                            "captures' span beyond them: capture more heights near that end, or "
                            "set the spool farther from the surface's way there",
                            end_mm));
    return {};
}

Result<void> check_errors(HeightFit const& fit, double ruler_error_mm)
{
    double const most_mm = std::max(kMinKnown_mm, kKnownInRulers * ruler_error_mm);
    for (int step = 0; step <= kRangeSteps; ++step) {
        double const counts
            = fit.low_counts + (fit.high_counts - fit.low_counts) * step / kRangeSteps;
        double const error_mm = height_error_mm(fit, counts);
        if (!(error_mm <= most_mm))
            return fail(Fault::User,
                        fmt::format("the captures leave the height near {:.0f} mm open by "
                                    "{:.1f} mm: capture more heights near it",
                                    height_mm(fit.model, counts).value_or(0), error_mm));
    }
    return {};
}

} // namespace

Result<void> check_range(HeightFit const& fit, std::span<HeightCapture const> captures,
                         HeightFitOptions const& options)
{
    auto const used = captures_without(captures, fit.slipped);
    if (auto const broken = find_break(fit.model, reading_range(used)))
        return fail(Fault::User,
                    fmt::format("the {} law that fits best {} at a reading of {:.0f}, between the "
                                "captures: check what was typed, and capture more heights near it",
                                name_of(fit.model), broken->turns ? "turns round" : "ends",
                                broken->counts));
    TRY(check_bend(bend_of(fit.model)));
    TRY(check_ends(fit, span_to_hold(used)));
    return check_errors(fit, options.ruler_error_mm);
}

Result<void> check_calibrated_range(Rig const& rig)
{
    auto const broken
        = find_break(rig.height_model, { rig.calibrated_min_counts, rig.calibrated_max_counts });
    if (!broken)
        return {};
    return fail(Fault::User,
                fmt::format("the height's model {} at a reading of {:.0f}, within the calibrated "
                            "range: calibrate the height again, with more captures",
                            broken->turns ? "turns round" : "has no height", broken->counts));
}

} // namespace tractus::calib
