#include "app/controllers/calibration_panel_controller.h"

#include "app/calibration/height_plots.h"
#include "app/calibration/live_calibration.h"
#include "app/calibration/simulated_calibration.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::controllers {

Result<CalibrationPanelController>
CalibrationPanelController::create(std::vector<drivers::DeviceInfo> devices,
                                   CalibrationPanelControllerOptions options)
{
    auto controller = TRY(calibration::CalibrationController::create(devices, options.controller));
    return CalibrationPanelController(std::move(devices), std::move(options),
                                      std::move(controller));
}

CalibrationPanelController::CalibrationPanelController(
    std::vector<drivers::DeviceInfo> devices, CalibrationPanelControllerOptions options,
    calibration::CalibrationController controller)
    : devices_(std::move(devices))
    , options_(std::move(options))
    , controller_(std::move(controller))
{
    propose();
    show_reading();
}

void CalibrationPanelController::push(devices::LiveReport const& report)
{
    controller_.push(report.device, report.report.received, report.report.bytes());
}

void CalibrationPanelController::advance()
{
    if (was_capturing_ && !controller_.is_capturing()) {
        was_capturing_ = false;
        if (controller_.refusal().empty())
            fit();
        else
            refuse(controller_.refusal());
    }
    bool const waits = calibration::takes_captures(controller_.procedure()) && !was_capturing_;
    if (controller_.take_pen_rest() && waits)
        // Captures at the time at which the pen rested, not at which this was noticed.
        capture(controller_.pen()->time, view_.proposed_mm);
    show_reading();
}

void CalibrationPanelController::perform(calibration::CalibrationCommand const& command)
{
    std::visit([&](auto const& kind) { perform_kind(kind); }, command);
    show_reading();
}

void CalibrationPanelController::perform_kind(calibration::ChooseProcedure const& command)
{
    auto options = options_.controller;
    options.procedure = command.procedure;
    options.rig = outcome_ ? outcome_->rig : controller_.rig();
    auto controller = calibration::CalibrationController::create(devices_, options);
    if (!controller)
        return refuse(controller.error().message);
    options_.controller = std::move(options);
    options_.heights_mm.clear();
    controller_ = *std::move(controller);
    view_ = {};
    outcome_.reset();
    is_moving_ = was_capturing_ = false;
    propose();
}

void CalibrationPanelController::perform_kind(calibration::CaptureHeight const& command)
{
    capture(options_.now(), command.ruler_mm);
}

void CalibrationPanelController::perform_kind(calibration::UndoCapture const&)
{
    if (command(options_.now(), "undo"))
        fit();
}

void CalibrationPanelController::perform_kind(calibration::BeginMovement const&)
{
    is_moving_ = command(options_.now(), "begin");
    propose();
}

void CalibrationPanelController::perform_kind(calibration::EndMovement const&)
{
    is_moving_ = false;
    if (command(options_.now(), "end"))
        fit();
}

void CalibrationPanelController::perform_kind(calibration::KeepRig const&)
{
    if (!outcome_)
        return;
    auto const kept = options_.keep(*outcome_);
    if (!kept)
        return refuse(kept.error().message);
    kept_ = outcome_->rig;
    view_.message = *kept;
    view_.is_refusal = false;
}

void CalibrationPanelController::perform_kind(calibration::PressWithPen const&)
{
    command(options_.now(), "press");
}

void CalibrationPanelController::capture(Timestamp time, double ruler_mm)
{
    was_capturing_ = command(time, fmt::format("capture {}", ruler_mm));
}

bool CalibrationPanelController::command(Timestamp time, std::string const& words)
{
    auto const done = controller_.command(time, words);
    if (!done)
        refuse(done.error().message);
    return done.has_value();
}

// Fits the captures so far. If there are too few of them, that is not shown as an error.
void CalibrationPanelController::fit()
{
    constexpr std::size_t kFewCaptures = 3;
    propose();
    outcome_.reset();
    view_.report.clear();
    view_.plots.clear();
    view_.residuals_mm.clear();
    view_.slipped.clear();
    auto outcome = controller_.finish(options_.date);
    if (!outcome) {
        if (!calibration::takes_captures(controller_.procedure())
            || controller_.captures().size() >= kFewCaptures)
            refuse(outcome.error().message);
        return;
    }
    outcome_ = *std::move(outcome);
    view_.report = outcome_->report;
    if (auto const& height_fit = outcome_->height_fit) {
        view_.residuals_mm = height_fit->residuals_mm;
        view_.slipped = height_fit->slipped;
        view_.plots = calibration::height_plots(*height_fit, controller_.captures(),
                                                outcome_->rig.full_scale_counts);
    }
}

// Proposes the height to capture next.
void CalibrationPanelController::propose()
{
    auto const heights = options_.heights_mm.empty()
        ? calibration::proposed_heights_mm(controller_.procedure())
        : options_.heights_mm;
    auto const next = controller_.captures().size();
    view_.is_refusal = false;
    if (!calibration::takes_captures(controller_.procedure())) {
        auto const words = calibration::movement_words(controller_.procedure());
        view_.message = is_moving_ ? fmt::format("{}, then press End.", words.during)
                                   : fmt::format("{}, then press Begin.", words.before);
    } else if (next < heights.size()) {
        view_.proposed_mm = heights[next];
        view_.message = fmt::format("Set the surface to {:g} mm, or any other height, let it rest, "
                                    "and press Capture or rest the pen on the tablet.",
                                    view_.proposed_mm);
    } else {
        view_.message = "Press Keep to write the rig's file, or capture more heights.";
    }
}

void CalibrationPanelController::show_reading()
{
    auto const reading = controller_.reading();
    view_.procedure = controller_.procedure();
    view_.reading = was_capturing_ ? "capturing …" : calibration::describe_reading(controller_);
    view_.is_on_rail = reading && reading->is_on_rail;
    view_.is_capturing = was_capturing_;
    view_.may_capture = reading && reading->is_at_rest && !was_capturing_;
    view_.is_moving = is_moving_;
    view_.captures = controller_.captures();
    view_.may_keep = outcome_.has_value();
}

void CalibrationPanelController::refuse(std::string const& why)
{
    view_.message = why;
    view_.is_refusal = true;
}

} // namespace tractus::controllers
