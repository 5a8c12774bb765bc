#include "app/calibration/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>

namespace tractus::calibration {

namespace {

std::string describe_candidates(calib::HeightFit const& fit)
{
    std::string text;
    for (auto const& candidate : fit.candidates)
        text += fmt::format(
            "  {:8} {:2} parameters, residuals {:.3f} mm RMS{}{}\n", calib::name_of(candidate.kind),
            candidate.parameters, candidate.rms_mm,
            candidate.slipped ? fmt::format(", {} left out", candidate.slipped) : "",
            candidate.p_value ? fmt::format(", p = {:.2g}", *candidate.p_value) : "");
    return text;
}

std::string describe_slips(calib::HeightCalibration const& calibration)
{
    std::string text;
    for (auto const slipped : calibration.fit.slipped)
        text
            += fmt::format("  capture {} at {:g} mm is off by {:+.1f} mm and was left out: measure "
                           "it again\n",
                           slipped + 1, calibration.captures[slipped].ruler_mm,
                           calibration.fit.residuals_mm[slipped]);
    return text;
}

// Describes doubts that remain after a successful fit, and what to do about them.
std::string describe_doubts(calib::HeightCalibration const& calibration)
{
    auto const& fit = calibration.fit;
    auto const used = calibration.captures.size() - fit.slipped.size();
    auto const parameters = static_cast<std::size_t>(calib::parameters_of(fit.model).size());
    std::string text;
    if (used <= parameters)
        text += "  the captures are as few as the model's parameters, so nothing checks it: take "
                "five or more\n";
    else if (fit.capture_error_mm > 3 * calibration.options.ruler_error_mm)
        text
            += fmt::format("  the residuals are {:.0f} times the ruler's error: the model does not "
                           "suit the sensor, or the captures are too few to tell a better one\n",
                           fit.capture_error_mm / calibration.options.ruler_error_mm);
    if (fit.hysteresis && std::abs(fit.hysteresis->mm) > 3 * fit.hysteresis->standard_error_mm
        && std::abs(fit.hysteresis->mm) > 0.5)
        text += "  up and down differ: look for slack in the string and play in its ends\n";
    return text;
}

std::string by_data_sheet(double linearity_percent)
{
    return linearity_percent > 0 ? fmt::format("{:g} % by its data sheet", linearity_percent)
                                 : "its data sheet's linearity was not told";
}

} // namespace

std::string describe(calib::HeightCalibration const& calibration, calib::Rig const& rig)
{
    auto const& fit = calibration.fit;
    auto const& record = rig.calibration.height.value();
    auto text = fmt::format("height: {}\n", fit.reason) + describe_candidates(fit);
    for (auto const& parameter : fit.parameters)
        text += fmt::format("  {} = {:.6g} ± {:.2g}\n", parameter.name, parameter.value,
                            parameter.standard_error);
    text += describe_slips(calibration);
    text += fmt::format("  residuals: {:.2f} mm RMS, {:.2f} mm at most\n", fit.rms_mm, fit.max_mm);
    if (fit.bend_percent > 0)
        text += fmt::format("  the potentiometer's track bends by {:.2g} % of the range, as far as "
                            "{} captures can tell ({})\n",
                            fit.bend_percent, calibration.captures.size(),
                            by_data_sheet(calibration.options.linearity_percent));
    if (fit.hysteresis)
        text += fmt::format("  up against down: {:+.2f} ± {:.2f} mm\n", fit.hysteresis->mm,
                            fit.hysteresis->standard_error_mm);
    text += fmt::format("  noise at rest: {:.2f} counts, {:.3f} mm at the bottom, {:.3f} mm at the "
                        "top\n",
                        fit.noise_counts, fit.noise_counts * record.mm_per_count.x(),
                        fit.noise_counts * record.mm_per_count.y());
    text += fmt::format("  resolution: {:.3g} mm per count at the bottom, {:.3g} at the top\n",
                        record.mm_per_count.x(), record.mm_per_count.y());
    text += fmt::format("  calibrated from {}, with {} captures\n",
                        describe_heights(fit.low_mm, fit.high_mm), calibration.captures.size());
    return text + describe_doubts(calibration);
}

std::string describe(calib::TravelFit const& fit)
{
    return fmt::format(
        "travel: per metre of rise the surface drifts {:+.2f} ± {:.2f} mm to the "
        "right and {:+.2f} ± {:.2f} mm away\n"
        "  its way is tilted by {:.3f} ± {:.3f} degrees against the tablet's normal\n"
        "  {} touches over {:.0f} mm, {:.2f} mm off the edge\n",
        1000 * fit.shear.x(), 1000 * fit.shear_error.x(), 1000 * fit.shear.y(),
        1000 * fit.shear_error.y(), degrees(fit.tilt_rad), degrees(fit.tilt_error_rad), fit.touches,
        fit.rise_mm, fit.rms_mm);
}

std::string describe(calib::LatencyFit const& fit, calib::Rig const& rig)
{
    auto text = fmt::format(
        "latency: the pen arrives {:.2f} ± {:.2f} ms {} than the height\n"
        "  so the tablet's latency is {:.2f} ms and the height sensor's {:.2f} ms\n"
        "  {} touches over {:.0f} mm, {:.2f} mm off the edge, correlation {:.5f}\n"
        "  up against down: {:+.2f} ± {:.2f} mm along the edge, which is no latency\n",
        std::abs(fit.delay_ms), fit.error_ms, fit.delay_ms < 0 ? "earlier" : "later",
        1000 * to_seconds(rig.tablet_latency), 1000 * to_seconds(rig.height_latency), fit.touches,
        fit.run_mm, fit.rms_mm, fit.correlation, fit.direction_mm, fit.direction_error_mm);
    if (std::abs(fit.direction_mm) > 0.3 && std::abs(fit.direction_mm) > 3 * fit.direction_error_mm)
        text += "  the pen is dragged or the string has slack: look for play in both\n";
    return text;
}

std::string describe(calib::TiltFit const& fit)
{
    Vec2 const& height = fit.coil_height_mm;
    Vec2 const& error = fit.coil_height_error_mm;
    auto text = fmt::format(
        "tilt: the tablet sees the pen {:.2f} ± {:.2f} mm above its nib to the left and right, "
        "{:.2f} ± {:.2f} mm towards you and away\n"
        "  leaned from {:.0f} to {:+.0f} degrees to the right, from {:.0f} to {:+.0f} away\n"
        "  {} touches, {:.2f} mm off the nib's place\n",
        height.x(), error.x(), height.y(), error.y(), degrees(fit.min_tilt_rad.x()),
        degrees(fit.most_tilt_rad.x()), degrees(fit.min_tilt_rad.y()),
        degrees(fit.most_tilt_rad.y()), fit.touches, fit.rms_mm);
    if (fit.is_corrected())
        return text
            + "  that is nothing: the tablet corrects for a pen that leans, so the rig does not\n";
    constexpr double kPlainly_mm = 1;
    for (int axis = 0; axis < 2; ++axis)
        if (height[axis] < -std::max(kPlainly_mm, 3 * error[axis]))
            text += fmt::format("  below zero: the tablet tells tilts {} the other way round, or "
                                "corrects for too much\n",
                                axis == 0 ? "to the left and right" : "towards you and away");
    return text;
}

std::string describe(calib::HeightCheck const& check)
{
    auto text = calib::quote(check) + "\n";
    for (std::size_t i = 0; i < check.heights_mm.size(); ++i)
        text += fmt::format("  at {:g} mm: {:+.2f} mm\n", check.heights_mm[i], check.errors_mm[i]);
    if (!check.known_mm.empty())
        text
            += fmt::format("  {} mm was used for the fit, which proves less: check other heights\n",
                           fmt::join(check.known_mm, ", "));
    if (!check.outside_mm.empty())
        text += fmt::format("  {} mm is outside the calibrated range\n",
                            fmt::join(check.outside_mm, ", "));
    return text;
}

std::string describe(calib::Zeroing const& zeroing, calib::Rig const& before,
                     std::span<calib::HeightCapture const> captures)
{
    std::string text;
    for (auto const& capture : captures)
        text += fmt::format("zero: what was {:.2f} mm is {:.2f} mm now, {:g} by the ruler\n",
                            calib::height_mm(before.height_model, capture.counts).value_or(0),
                            calib::height_mm(zeroing.rig.height_model, capture.counts).value_or(0),
                            capture.ruler_mm);
    text += zeroing.cause == calib::ZeroCause::Slipped
        ? "  as after a slip of the string; the scale is as it was\n"
        : "  as after a move of the table; the scale is as it was\n";
    return text;
}

std::string describe_question(calib::Zeroing const& zeroing)
{
    return fmt::format("  if the table, the spool's stand or the ruler moved instead, heights are "
                       "up to {:.1f} mm wrong now: capture a second height, far from the first, or "
                       "say --cause moved\n",
                       zeroing.difference_if_other_cause_mm);
}

std::string describe_heights(double low_mm, double high_mm)
{
    // Adding 0.0 turns "-0.0" into "0.0".
    auto const tenths = [](double mm) { return std::round(mm * 10) / 10 + 0.0; };
    return fmt::format("{:.1f} to {:.1f} mm", tenths(low_mm), tenths(high_mm));
}

} // namespace tractus::calibration
