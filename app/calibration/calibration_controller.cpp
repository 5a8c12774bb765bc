#include "app/calibration/calibration_controller.h"

#include "app/calibration/calibration_report.h"
#include "calib/height_fit_range.h"
#include "drivers/height_decoders.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace tractus::calibration {

namespace {

constexpr std::array<std::string_view, 6> kNames { "height", "travel", "latency",
                                                   "tilt",   "zero",   "check" };
constexpr Duration kPenRest = std::chrono::milliseconds(500);
constexpr double kPenStill_mm = 4;
constexpr double kFarthest_mm = 10'000;
// If the last reading of a capture is older than this at its end, the sensor has failed.
constexpr Duration kSilence = std::chrono::milliseconds(250);

Result<double> parse_height(std::string_view text)
{
    double height_mm = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), height_mm);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(height_mm)
        || std::abs(height_mm) > kFarthest_mm)
        return fail(Fault::User,
                    fmt::format("\"{}\" is no height: give millimetres, such as 120.5", text));
    return height_mm;
}

} // namespace

std::string_view name_of(CalibrationProcedure procedure)
{
    return kNames[static_cast<std::size_t>(procedure)];
}

bool takes_captures(CalibrationProcedure procedure)
{
    return procedure != CalibrationProcedure::Travel && procedure != CalibrationProcedure::Latency
        && procedure != CalibrationProcedure::Tilt;
}

Result<CalibrationController>
CalibrationController::create(std::span<drivers::DeviceInfo const> devices, Options options)
{
    CalibrationController controller(std::move(options));
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!controller.pen_decoder_)
            if (auto pen = drivers::make_pen_decoder(devices[i])) {
                controller.pen_decoder_ = *std::move(pen);
                controller.pen_device_ = i;
                continue;
            }
        if (!controller.height_decoder_)
            if (auto height = drivers::make_height_decoder(devices[i])) {
                controller.height_decoder_ = *std::move(height);
                controller.height_device_ = i;
                controller.sensor_ = calib::identity_of(devices[i]);
            }
    }
    if (!controller.height_decoder_ && needs_height(controller.procedure()))
        return fail(Fault::User,
                    "there is no height sensor to calibrate: connect it, or name it "
                    "with --device");
    if (!controller.pen_decoder_ && !takes_captures(controller.procedure()))
        return fail(Fault::User,
                    fmt::format("there is no pen, and {} needs one: connect the tablet, or name it "
                                "with --device",
                                name_of(controller.procedure())));
    if (controller.procedure() == CalibrationProcedure::Tilt
        && !controller.pen_decoder_->traits().has_tilt)
        return fail(Fault::User,
                    fmt::format("{} tells no tilt, so there is nothing to calibrate, and nothing "
                                "that tips could be corrected by",
                                devices[controller.pen_device_].name));
    return controller;
}

void CalibrationController::push(std::size_t device, Timestamp received,
                                 std::span<std::byte const> report)
{
    if (report.empty()) {
        if (pending_ && device == height_device_)
            refuse_capture("the height sensor was unplugged during it: plug it in, then capture "
                           "that height again");
        return;
    }
    if (pen_decoder_ && device == pen_device_) {
        new_pens_.clear();
        (void)pen_decoder_->decode(received, report, new_pens_);
        for (auto const& sample : new_pens_)
            push_pen(sample);
    } else if (height_decoder_ && device == height_device_) {
        new_heights_.clear();
        // Errors are ignored, as the samples decoded before an error are usable.
        (void)height_decoder_->decode(received, report, new_heights_);
        for (auto const& sample : new_heights_)
            push_height(sample);
    }
}

void CalibrationController::push_pen(drivers::PenSample const& sample)
{
    bool const begins = sample.touching && !(pen_ && pen_->touching);
    pen_ = sample;
    if (begins)
        pens_before_touch_ = pens_.size();
    is_pressing_ &= sample.touching;
    if (!sample.touching)
        touch_.reset();
    else if (!touch_ || (sample.position_mm - touch_->position_mm).norm() > kPenStill_mm) {
        touch_ = sample;
        is_rest_reported_ = false;
    }
    if (!takes_captures(procedure()) && is_moving_ && !is_pressing_) {
        pens_.push_back(sample);
        touches_ += sample.touching;
    }
}

void CalibrationController::push_height(drivers::HeightSample const& sample)
{
    recent_.add(sample);
    if (!takes_captures(procedure()))
        heights_.push_back(sample);
    if (!pending_ || sample.time < pending_->begin)
        return;
    if (sample.time - pending_->begin < calib::kCaptureTime)
        pending_->samples.push_back(sample);
    else
        close_capture(sample.time);
}

void CalibrationController::refuse_capture(std::string_view reason)
{
    refusal_ = fmt::format("the capture at {:g} mm: {}", pending_->ruler_mm, reason);
    refusals_.push_back(refusal_);
    pending_.reset();
}

// Ends a capture. `now` is the time of the first reading after the capture.
void CalibrationController::close_capture(Timestamp now)
{
    auto const last = pending_->samples.empty() ? pending_->begin : pending_->samples.back().time;
    if (now - last > kSilence)
        return refuse_capture(fmt::format("the height sensor was silent for {:.2f} s from within "
                                          "it: was it unplugged? Check its cable, then capture "
                                          "that height again",
                                          to_seconds(now - last)));
    auto const capture = calib::capture_at_rest(pending_->samples, pending_->ruler_mm);
    if (!capture)
        return refuse_capture(capture.error().message);
    pending_.reset();
    refusal_.clear();
    captures_.push_back(*capture);
    captures_.back().from = calib::direction(last_ruler_mm_, capture->ruler_mm);
    last_ruler_mm_ = capture->ruler_mm;
}

bool CalibrationController::take_pen_rest()
{
    if (!touch_ || is_pressing_ || is_rest_reported_ || pen_->time - touch_->time < kPenRest)
        return false;
    is_rest_reported_ = true;
    return true;
}

Result<void> CalibrationController::capture(Timestamp time, std::string_view height)
{
    if (pending_ && time - pending_->begin > 2 * calib::kCaptureTime)
        return fail(Fault::Device,
                    fmt::format("the height sensor fell silent during the capture at {:g} mm: was "
                                "it unplugged? Check its cable, then capture that height again",
                                pending_->ruler_mm));
    if (pending_)
        return fail(Fault::User, "a capture is under way: wait a second for its end");
    pending_ = Pending { .ruler_mm = TRY(parse_height(height)), .begin = time };
    return {};
}

// Undoes the last capture. If a capture is in progress, only cancels it; an earlier refusal
// remains.
void CalibrationController::undo()
{
    if (pending_) {
        pending_.reset();
        return;
    }
    if (refusal_.empty() && !captures_.empty()) {
        captures_.pop_back();
        last_ruler_mm_
            = captures_.empty() ? std::nullopt : std::optional(captures_.back().ruler_mm);
    }
    refusal_.clear();
}

Result<void> CalibrationController::drop(std::string_view number)
{
    std::size_t which = 0;
    auto const [end, error] = std::from_chars(number.data(), number.data() + number.size(), which);
    if (error != std::errc() || end != number.data() + number.size() || which < 1
        || which > captures_.size())
        return fail(Fault::User,
                    fmt::format("\"{}\" is no capture to drop: there are {}, counted from 1",
                                number, captures_.size()));
    captures_.erase(captures_.begin() + static_cast<std::ptrdiff_t>(which - 1));
    return {};
}

std::optional<calib::HeightFitDoubt> CalibrationController::doubt() const
{
    if (procedure() != CalibrationProcedure::Height)
        return std::nullopt;
    auto const fit = calib::fit_height(captures_, options_.height);
    return fit ? calib::doubt_about(*fit, captures_, options_.height) : std::nullopt;
}

Result<void> CalibrationController::command(Timestamp time, std::string_view words)
{
    constexpr std::string_view kCapture = "capture ";
    constexpr std::string_view kDrop = "drop ";
    constexpr std::string_view kCause = "cause ";
    if (last_command_ && time < *last_command_)
        return fail(Fault::User,
                    fmt::format("\"{}\" at {:.3f} s comes after a command at {:.3f} s: captures "
                                "are out of order, so the log was changed; record it again",
                                words, to_seconds(time), to_seconds(*last_command_)));
    last_command_ = time;
    if (takes_captures(procedure()) && words.starts_with(kCapture))
        return capture(time, words.substr(kCapture.size()));
    if (takes_captures(procedure()) && words.starts_with(kDrop))
        return drop(words.substr(kDrop.size()));
    if (takes_captures(procedure()) && words == "undo") {
        undo();
        return {};
    }
    if (!takes_captures(procedure()) && (words == "begin" || words == "end")) {
        is_moving_ = words == "begin";
        if (is_moving_)
            begin_movement();
        return {};
    }
    if (procedure() == CalibrationProcedure::Zero && words.starts_with(kCause)) {
        options_.zero_cause = calib::parse_zero_cause(words.substr(kCause.size()));
        if (options_.zero_cause)
            return {};
    }
    if (words == "press") {
        press();
        return {};
    }
    return fail(
        Fault::User,
        fmt::format("\"{}\" is no command of calibrate {}: expected {}", words,
                    name_of(procedure()),
                    takes_captures(procedure()) ? "capture MM, undo or drop N" : "begin or end"));
}

// Begins a movement: discards everything received before it.
void CalibrationController::begin_movement()
{
    pens_.clear();
    pens_before_touch_ = 0;
    touches_ = 0;
}

void CalibrationController::press()
{
    if (!pen_ || !pen_->touching || is_pressing_)
        return;
    is_pressing_ = true;
    auto const of_touch = pens_.begin() + static_cast<std::ptrdiff_t>(pens_before_touch_);
    touches_ -= static_cast<std::size_t>(std::count_if(
        of_touch, pens_.end(), [](drivers::PenSample const& pen) { return pen.touching; }));
    pens_.erase(of_touch, pens_.end());
}

Result<CalibrationOutcome> CalibrationController::finish(std::string const& date) const
{
    auto outcome = TRY(conclude(date));
    for (auto const& refusal : refusals_)
        outcome.report += fmt::format("  not used: {}\n", refusal);
    return outcome;
}

Result<CalibrationOutcome> CalibrationController::conclude(std::string const& date) const
{
    if (pending_)
        return fail(Fault::Device,
                    fmt::format("the readings end before the capture at {:g} mm does: check that "
                                "the height sensor sends, then capture it again",
                                pending_->ruler_mm));
    if (!refusal_.empty())
        return fail(Fault::User, refusal_);
    switch (procedure()) {
    case CalibrationProcedure::Height:
        return finish_height(date);
    case CalibrationProcedure::Travel:
        return finish_travel(date);
    case CalibrationProcedure::Latency:
        return finish_latency(date);
    case CalibrationProcedure::Tilt:
        return finish_tilt(date);
    case CalibrationProcedure::Zero:
        return finish_zero();
    case CalibrationProcedure::Check:
        return finish_check(date);
    }
    return CalibrationOutcome {};
}

Result<CalibrationOutcome> CalibrationController::finish_height(std::string const& date) const
{
    auto fit = TRY(calib::fit_height(captures_, options_.height));
    auto const doubt = calib::doubt_about(fit, captures_, options_.height);
    if (doubt && !options_.is_forced)
        return fail(Fault::User, doubt->reason + " (--force keeps the fit all the same)");
    TRY(calib::check_range(fit, captures_, options_.height));
    calib::HeightCalibration const calibration { .fit = std::move(fit),
                                                 .captures = captures_,
                                                 .options = options_.height,
                                                 .full_scale_counts = height_decoder_->full_scale(),
                                                 .sensor = sensor_ };
    CalibrationOutcome outcome { .rig = calib::with_height(options_.rig, calibration, date),
                                 .height_fit = calibration.fit };
    if (pen_decoder_ && !pen_decoder_->traits().is_size_assumed)
        // Rounded to micrometres.
        outcome.rig.tablet_size_mm = (pen_decoder_->traits().size_mm.array() * 1000).round() / 1000;
    outcome.report = describe(calibration, outcome.rig);
    if (doubt)
        outcome.report += fmt::format("  kept by force: {}\n", doubt->reason);
    return outcome;
}

Result<CalibrationOutcome> CalibrationController::finish_travel(std::string const& date) const
{
    auto const fit = TRY(calib::fit_travel(pens_, heights_, options_.rig));
    return CalibrationOutcome { .rig = calib::with_travel(options_.rig, fit, date),
                                .report = describe(fit) };
}

Result<CalibrationOutcome> CalibrationController::finish_latency(std::string const& date) const
{
    auto const fit = TRY(calib::fit_latency(pens_, heights_, options_.rig));
    CalibrationOutcome outcome { .rig = calib::with_latency(options_.rig, fit, date) };
    outcome.report = describe(fit, outcome.rig);
    return outcome;
}

Result<CalibrationOutcome> CalibrationController::finish_tilt(std::string const& date) const
{
    auto const fit = TRY(calib::fit_tilt(pens_));
    return CalibrationOutcome { .rig = calib::with_tilt(options_.rig, fit, date),
                                .report = describe(fit) };
}

std::optional<calib::Zeroing> CalibrationController::open_question() const
{
    constexpr double kMinDifferenceToAsk_mm = 0.2;
    if (procedure() != CalibrationProcedure::Zero)
        return std::nullopt;
    auto const zeroing = calib::zeroed(options_.rig, captures_, height_decoder_->full_scale(),
                                       options_.zero_cause);
    if (!zeroing || zeroing->is_told
        || zeroing->difference_if_other_cause_mm < kMinDifferenceToAsk_mm)
        return std::nullopt;
    return *zeroing;
}

Result<CalibrationOutcome> CalibrationController::finish_zero() const
{
    auto zeroing = TRY(
        calib::zeroed(options_.rig, captures_, height_decoder_->full_scale(), options_.zero_cause));
    auto report = describe(zeroing, options_.rig, captures_);
    if (open_question())
        report += describe_question(zeroing);
    return CalibrationOutcome { .rig = std::move(zeroing.rig), .report = std::move(report) };
}

Result<CalibrationOutcome> CalibrationController::finish_check(std::string const& date) const
{
    auto const check
        = TRY(calib::check_height(captures_, height_decoder_->full_scale(), options_.rig));
    return CalibrationOutcome { .rig = calib::with_check(options_.rig, check, date),
                                .report = describe(check) };
}

} // namespace tractus::calibration
