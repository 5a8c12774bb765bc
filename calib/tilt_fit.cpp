#include "calib/tilt_fit.h"

#include "calib/lean_track.h"
#include "calib/pen_track.h"
#include "calib/plane_lines.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <map>
#include <vector>

namespace tractus::calib {

namespace {

constexpr std::size_t kMinTiltTouches = 200;
constexpr double kMinSpan_deg = 40;
constexpr double kMaxMoved_mm = 1;
// Standard deviation of the nib's position if it shifts up to 0.1 mm to either side.
constexpr double kPlay_mm = 0.06;
constexpr std::size_t kFewInStretch = 5; // Least number of touches in half a second for a mean.

struct Leant {
    std::vector<PlaneSighting> sightings {};
    Vec2 min_tilt_rad = Vec2::Zero();
    Vec2 most_tilt_rad = Vec2::Zero();
};

void find_span(std::vector<double> tilts, double& least, double& most)
{
    std::sort(tilts.begin(), tilts.end());
    auto const left_out = tilts.size() / 40;
    least = tilts[left_out];
    most = tilts[tilts.size() - 1 - left_out];
}

Result<Leant> touches_of(std::span<drivers::PenSample const> pens)
{
    LeanTrack leans(std::chrono::hours(24));
    for (auto const& pen : pens)
        leans.add(pen);
    Leant leant;
    std::vector<double> tilts_x;
    std::vector<double> tilts_y;
    for (auto const& pen : pens) {
        auto const lean = leans.at(pen.time);
        if (!pen.touching || !pen.tilt_rad || !lean)
            continue;
        leant.sightings.push_back(
            { .position_mm = pen.position_mm, .against = *lean, .stretch = stretch_of(pen.time) });
        tilts_x.push_back(pen.tilt_rad->x());
        tilts_y.push_back(pen.tilt_rad->y());
    }
    bool const tells_none = leant.sightings.empty()
        && std::any_of(pens.begin(), pens.end(), [](auto const& pen) { return pen.touching; });
    if (tells_none)
        return fail(Fault::User,
                    "the tablet tells no tilt for this pen, so there is nothing to "
                    "calibrate, and nothing that tips could be corrected by");
    if (leant.sightings.size() < kMinTiltTouches)
        return fail(Fault::User,
                    fmt::format("the pen touched in only {} reports, expected at least {}: keep "
                                "its nib on the tablet and lean it around for ten seconds or more",
                                leant.sightings.size(), kMinTiltTouches));
    find_span(std::move(tilts_x), leant.min_tilt_rad.x(), leant.most_tilt_rad.x());
    find_span(std::move(tilts_y), leant.min_tilt_rad.y(), leant.most_tilt_rad.y());
    return leant;
}

Result<void> check_span(Leant const& leant)
{
    Vec2 const span = leant.most_tilt_rad - leant.min_tilt_rad;
    if (span.isZero(0))
        return fail(Fault::User,
                    "the tilt that the tablet tells never changed: lean the pen around, and if it "
                    "was, the tablet tells none for this pen");
    if (degrees(span.minCoeff()) >= kMinSpan_deg)
        return {};
    bool const is_x = span.x() <= span.y();
    return fail(Fault::User,
                fmt::format("the pen leaned over only {:.0f} degrees {}, expected at least {}: "
                            "lean it farther to either side",
                            degrees(span.minCoeff()),
                            is_x ? "to the left and right" : "towards you and away", kMinSpan_deg));
}

// Returns how far the nib strayed from its overall position: the greatest distance of its mean
// position over half a second.
double moved_mm(PlaneLines const& lines, std::vector<PlaneSighting> const& sightings)
{
    struct Sum {
        Vec2 misses_mm = Vec2::Zero();
        std::size_t count = 0;
    };
    std::map<int, Sum> stretches;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        auto& sum = stretches[sightings[i].stretch];
        sum.misses_mm += lines.misses_mm[i];
        ++sum.count;
    }
    double most_mm = 0;
    for (auto const& [stretch, sum] : stretches)
        if (sum.count >= kFewInStretch)
            most_mm = std::max(most_mm, sum.misses_mm.norm() / static_cast<double>(sum.count));
    return most_mm;
}

// Combines a standard error with that caused by the play of the nib in its dent.
Vec2 with_play(Vec2 const& error_mm)
{
    return (error_mm.array().square() + kPlay_mm * kPlay_mm).sqrt();
}

} // namespace

bool TiltFit::is_corrected() const
{
    return (coil_height_mm.array().abs() <= 2 * coil_height_error_mm.array()).all();
}

Result<TiltFit> fit_tilt(std::span<drivers::PenSample const> pens)
{
    auto const leant = TRY(touches_of(pens));
    TRY(check_span(leant));
    auto const lines = fit_plane_lines(leant.sightings);
    double const moved = moved_mm(lines, leant.sightings);
    if (moved > kMaxMoved_mm)
        return fail(Fault::User,
                    fmt::format("the nib moved by {:.1f} mm, expected at most {}: keep it in one "
                                "dent, on the tablet all the time, and lean the pen slowly",
                                moved, kMaxMoved_mm));
    return TiltFit { .coil_height_mm = lines.slope,
                     .coil_height_error_mm = with_play(lines.slope_error),
                     .min_tilt_rad = leant.min_tilt_rad,
                     .most_tilt_rad = leant.most_tilt_rad,
                     .rms_mm = lines.rms_mm,
                     .touches = leant.sightings.size() };
}

Rig with_coil_height(Rig rig, TiltFit const& fit)
{
    rig.coil_height_mm = fit.is_corrected() ? Vec2::Zero() : fit.coil_height_mm;
    return rig;
}

} // namespace tractus::calib
