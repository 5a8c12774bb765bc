#include "calib/calibrate.h"

#include <cmath>
#include <cstdlib>
#include <fmt/core.h>

namespace tractus::calib {

namespace {

// Rounds `value` to `digits` significant digits. The conversion goes through decimal text, so that
// the printed value has no more digits.
double rounded(double value, int digits)
{
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

constexpr int kModelDigits = 10;
constexpr int kErrorDigits = 3;
constexpr int kFigureDigits = 5;

Vec2 rounded(Vec2 const& values, int digits)
{
    return { rounded(values.x(), digits), rounded(values.y(), digits) };
}

double worth_of_a_count(HeightModel const& model, double height_mm)
{
    auto const counts = counts_at_height(model, height_mm);
    return counts ? std::abs(mm_per_count_at(model, *counts).value_or(0)) : 0;
}

} // namespace

SensorIdentity identity_of(drivers::DeviceInfo const& info)
{
    return { .name = info.name,
             .id = fmt::format("{:04x}:{:04x}:{:04x}", info.bus, info.vendor_id, info.product_id),
             .serial = info.serial_number };
}

Rig with_height(Rig rig, HeightCalibration const& calibration, std::string const& date)
{
    auto const& fit = calibration.fit;
    auto parameters = parameters_of(fit.model);
    for (double& value : parameters)
        value = rounded(value, kModelDigits);
    rig.height_model = with_parameters(fit.model, parameters);
    auto bend = bend_of(fit.model);
    for (auto& knot : bend)
        knot = { rounded(knot.counts, kModelDigits), rounded(knot.shift_counts, kModelDigits) };
    rig.height_model = with_bend(std::move(rig.height_model), std::move(bend));
    rig.full_scale_counts = calibration.full_scale_counts;
    rig.calibrated_min_counts = fit.low_counts;
    rig.calibrated_max_counts = fit.high_counts;

    HeightRecord record { .date = date, .sensor = calibration.sensor };
    record.captures = calibration.captures;
    record.ruler_error_mm = calibration.options.ruler_error_mm;
    record.linearity_percent = calibration.options.linearity_percent;
    record.requested_kind = calibration.options.kind;
    record.reason = fit.reason;
    for (auto const& parameter : fit.parameters)
        record.errors.push_back(rounded(parameter.standard_error, kErrorDigits));
    record.slipped = fit.slipped;
    record.rms_mm = rounded(fit.rms_mm, kErrorDigits);
    record.max_mm = rounded(fit.max_mm, kErrorDigits);
    // Rounds to hundredths; adding 0.0 turns a negative zero into 0.
    record.heights_mm
        = Vec2(std::round(fit.low_mm * 100) / 100 + 0.0, std::round(fit.high_mm * 100) / 100 + 0.0);
    record.mm_per_count = rounded(Vec2(worth_of_a_count(rig.height_model, fit.low_mm + 0.1),
                                       worth_of_a_count(rig.height_model, fit.high_mm - 0.1)),
                                  kErrorDigits);
    record.noise_counts = rounded(fit.noise_counts, kErrorDigits);
    if (fit.hysteresis)
        record.hysteresis_mm
            = rounded(Vec2(fit.hysteresis->mm, fit.hysteresis->standard_error_mm), kErrorDigits);
    rig.calibration.height = std::move(record);
    rig.calibration.check.reset(); // The check belongs to the previous fit.
    return rig;
}

Rig with_travel(Rig rig, TravelFit const& fit, std::string const& date)
{
    rig.travel_shear = rounded(fit.shear, kFigureDigits);
    rig.calibration.travel
        = TravelRecord { .date = date,
                         .shear_error = rounded(fit.shear_error, kErrorDigits),
                         .tilt_deg = rounded(degrees(fit.tilt_rad), kFigureDigits),
                         .tilt_error_deg = rounded(degrees(fit.tilt_error_rad), kErrorDigits),
                         .rise_mm = rounded(fit.rise_mm, kFigureDigits),
                         .rms_mm = rounded(fit.rms_mm, kErrorDigits),
                         .touches = fit.touches };
    return rig;
}

Rig with_latency(Rig rig, LatencyFit const& fit, std::string const& date)
{
    auto delay = fit;
    delay.delay_ms = std::round(fit.delay_ms * 100) / 100;
    rig = with_delay(rig, delay);
    rig.calibration.latency
        = LatencyRecord { .date = date,
                          .delay_ms = delay.delay_ms,
                          .error_ms = rounded(fit.error_ms, kErrorDigits),
                          .correlation = rounded(fit.correlation, kFigureDigits),
                          .rms_mm = rounded(fit.rms_mm, kErrorDigits),
                          .touches = fit.touches,
                          .direction_mm
                          = rounded(Vec2(fit.direction_mm, fit.direction_error_mm), kErrorDigits) };
    return rig;
}

Rig with_tilt(Rig rig, TiltFit const& fit, std::string const& date)
{
    auto written = fit;
    written.coil_height_mm = rounded(fit.coil_height_mm, kFigureDigits);
    rig = with_coil_height(std::move(rig), written);
    auto const tenths_deg = [](Vec2 const& rad) -> Vec2 {
        return (rad.unaryExpr([](double angle) { return degrees(angle); }).array() * 10).round()
            / 10;
    };
    rig.calibration.tilt
        = TiltRecord { .date = date,
                       .coil_height_mm = written.coil_height_mm,
                       .coil_height_error_mm = rounded(fit.coil_height_error_mm, kErrorDigits),
                       .min_tilt_deg = tenths_deg(fit.min_tilt_rad),
                       .most_tilt_deg = tenths_deg(fit.most_tilt_rad),
                       .rms_mm = rounded(fit.rms_mm, kErrorDigits),
                       .touches = fit.touches };
    return rig;
}

Rig with_check(Rig rig, HeightCheck const& check, std::string const& date)
{
    CheckRecord record { .date = date, .heights_mm = check.heights_mm };
    for (double const error_mm : check.errors_mm)
        record.errors_mm.push_back(rounded(error_mm, kErrorDigits));
    record.within_mm = check.within_mm;
    rig.calibration.check = std::move(record);
    return rig;
}

Result<HeightFit> refit_height(Rig const& rig)
{
    auto const& record = rig.calibration.height;
    if (!record)
        return fail(Fault::User,
                    "the rig's height was not calibrated: use \"tractus calibrate "
                    "height\"");
    auto fit = TRY(fit_height(record->captures,
                              { .kind = record->requested_kind,
                                .ruler_error_mm = record->ruler_error_mm,
                                .linearity_percent = record->linearity_percent }));
    return fit;
}

} // namespace tractus::calib
