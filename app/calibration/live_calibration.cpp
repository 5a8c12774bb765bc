#include "app/calibration/live_calibration.h"

#include "app/calibration/log_calibration.h"
#include "app/devices/live_devices.h"
#include "drivers/sensors/sensor_volts.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calibration {

namespace {

constexpr Duration kShowEvery = std::chrono::milliseconds(100);
// A capture that takes longer than this is cancelled.
constexpr Duration kCaptureEndsAfter = calib::kCaptureTime + std::chrono::seconds(2);
constexpr char kEndOfInput = '\4';
constexpr char kBackspace = '\b';
constexpr char kDelete = '\177';

// Converts a time to the time that a log contains: microseconds since the recording's start.
Timestamp time_in_log(Timestamp time, Timestamp start)
{
    auto const since = std::max(time - start, Duration {});
    return Timestamp(std::chrono::duration_cast<std::chrono::microseconds>(since));
}

class Conversation {
public:
    Conversation(CalibrationController& controller, devices::LiveDevices& devices,
                 CalibrationPerson const& person, LiveCalibrationOptions const& options)
        : controller_(controller)
        , devices_(devices)
        , person_(person)
        , options_(options)
    {
        if (!takes_captures(controller.procedure()))
            is_moving_ = false;
    }

    // Runs the calibration to its end. Returns false if the user quit or `stop` was set.
    Result<bool> run(std::atomic<bool> const& stop)
    {
        ask();
        while (!stop && !is_done_ && !is_away_) {
            bool const any = take_reports();
            if (options_.recorder)
                TRY(options_.recorder->flush_if_due(options_.now()));
            TRY(hear());
            show();
            if (!any && !devices_.any_left() && is_moving_)
                TRY(finish());
            else if (!any && !devices_.any_left())
                return fail(Fault::User,
                            "the devices ended before the calibration did: give a "
                            "longer log, or connect them");
            if (!any)
                options_.rest(devices::kPollRest);
        }
        if (options_.recorder)
            TRY(options_.recorder->flush());
        return is_done_;
    }

private:
    bool take_reports()
    {
        reports_.clear();
        devices_.take(reports_);
        for (auto const& report : reports_) {
            controller_.push(report.device, time_in_log(report.report.received, options_.start),
                             report.report.bytes());
            newest_ = report.report.received;
            if (options_.recorder)
                options_.recorder->write(report);
        }
        return !reports_.empty();
    }

    Result<void> hear()
    {
        if (was_capturing_ && !controller_.is_capturing())
            return tell_capture();
        if (was_capturing_ && options_.now() - capture_began_ > kCaptureEndsAfter)
            return give_up_capture();
        if (was_capturing_)
            return hear_while_capturing();
        if (takes_captures(controller_.procedure()) && controller_.take_pen_rest() && next_height())
            // The capture begins at the time of the newest report, however late the rest is
            // noticed.
            return enter(newest_);
        if (auto const key = next_key())
            return press(*key);
        return {};
    }

    // Handles keys during a capture. Only quitting and undo act at once; other keys wait until the
    // capture is over.
    Result<void> hear_while_capturing()
    {
        if (person_.is_script)
            return {};
        auto const key = person_.key();
        // The end of input is ignored here, as the next call reports it again.
        if (!key || *key == kEndOfInput)
            return {};
        if (*key == 'q') {
            is_away_ = true;
        } else if (*key == 'u') {
            was_capturing_ = false;
            return undo();
        } else if (*key == 'f') {
            person_.say("a capture is under way: wait a second for its end, or press u to give it "
                        "up");
        } else {
            typed_ += *key;
        }
        return {};
    }

    // Cancels the current capture, because no more readings arrive.
    Result<void> give_up_capture()
    {
        was_capturing_ = false;
        TRY(command(options_.now(), "undo"));
        auto const why = "the height sensor fell silent during the capture: check its plug and its "
                         "cable, then capture again";
        if (person_.is_script)
            return fail(Fault::Device, why);
        person_.say(why);
        ask();
        return {};
    }

    std::optional<char> next_key()
    {
        if (typed_.empty())
            return person_.key();
        char const key = typed_.front();
        typed_.erase(0, 1);
        return key;
    }

    Result<void> press(char key)
    {
        switch (key) {
        case '\n':
        case '\r':
            return enter(options_.now());
        case kBackspace:
        case kDelete:
            if (!entry_.empty())
                entry_.pop_back();
            return {};
        case 'u':
            return undo();
        case 'f':
            return finish();
        case 's':
            return answer("slipped");
        case 'm':
            return answer("moved");
        case kEndOfInput:
            return go_on_alone();
        case 'q':
            is_away_ = true;
            return {};
        default:
            if ((key >= '0' && key <= '9') || key == '.' || key == '-')
                entry_ += key;
            return {};
        }
    }

    Result<void> command(Timestamp time, std::string const& words)
    {
        auto const done = controller_.command(time_in_log(time, options_.start), words);
        if (done && options_.recorder)
            options_.recorder->write_tool(time, kCalibrateTool, words);
        if (done || person_.is_script)
            return done;
        person_.say(done.error().message);
        return {};
    }

    Result<void> enter(Timestamp time)
    {
        if (!takes_captures(controller_.procedure())) {
            is_moving_ = !is_moving_;
            TRY(command(time, is_moving_ ? "begin" : "end"));
            is_done_ = !is_moving_;
            if (is_moving_)
                ask();
            return {};
        }
        auto const height = next_height();
        if (!height)
            return {}; // No height was typed, and none of the list remains.
        TRY(command(time, "capture " + *height));
        entry_.clear();
        was_capturing_ = controller_.is_capturing();
        capture_began_ = options_.now();
        return {};
    }

    // Returns the typed height, otherwise a height to repeat, otherwise the next height of the
    // list.
    std::optional<std::string> next_height() const
    {
        if (!entry_.empty())
            return entry_;
        if (!again_mm_.empty())
            return fmt::format("{}", again_mm_.front());
        if (controller_.captures().size() < options_.heights_mm.size())
            return fmt::format("{}", options_.heights_mm[controller_.captures().size()]);
        return std::nullopt;
    }

    Result<void> tell_capture()
    {
        was_capturing_ = false;
        if (!controller_.refusal().empty()) {
            if (person_.is_script)
                return fail(Fault::User, controller_.refusal());
            person_.say(controller_.refusal());
            return {};
        }
        auto const& capture = controller_.captures().back();
        person_.say(fmt::format("  {}. {:g} mm: {:.2f} counts, noise {:.2f}",
                                controller_.captures().size(), capture.ruler_mm, capture.counts,
                                capture.noise_counts));
        bool const was_again = !again_mm_.empty();
        if (was_again)
            again_mm_.erase(again_mm_.begin());
        bool const is_last = (was_again || !options_.heights_mm.empty())
            && controller_.captures().size() >= options_.heights_mm.size() && again_mm_.empty();
        if (controller_.procedure() == CalibrationProcedure::Zero)
            return finish_zero();
        if (is_last)
            return finish();
        ask();
        return {};
    }

    Result<void> finish_zero()
    {
        auto const question = controller_.open_question();
        if (!question || person_.is_script)
            return finish();
        is_asking_cause_ = true;
        person_.say(fmt::format("Why is the height off? s: the string slipped; m: the table, the "
                                "spool's stand or the ruler moved. It makes up to {:.1f} mm; if "
                                "you do not know, set the surface to a second height, far from the "
                                "first, type it and press Enter",
                                question->difference_if_other_cause_mm));
        return {};
    }

    Result<void> answer(std::string_view cause)
    {
        if (!is_asking_cause_)
            return {};
        TRY(command(options_.now(), fmt::format("cause {}", cause)));
        return finish();
    }

    // Returns true if the calibration may end. Otherwise drops captures that disagree with the
    // others, so that their heights are measured again. For a script, such captures are refused
    // later, when the rig is computed.
    Result<bool> may_finish()
    {
        auto const doubt = controller_.doubt();
        if (!doubt || person_.is_script || options_.is_forced)
            return true;
        person_.say(doubt->reason);
        for (auto i = doubt->captures.rbegin(); i != doubt->captures.rend(); ++i) {
            again_mm_.insert(again_mm_.begin(), controller_.captures()[*i].ruler_mm);
            TRY(command(options_.now(), fmt::format("drop {}", *i + 1)));
        }
        if (doubt->captures.empty())
            person_.say("u takes captures back, q leaves the rig as it was");
        else
            person_.say("  (f does without them)");
        ask();
        return false;
    }

    Result<void> undo()
    {
        if (!takes_captures(controller_.procedure()))
            return {};
        // Cancels the capture in progress, if there is one; otherwise undoes the last capture.
        TRY(command(options_.now(), "undo"));
        person_.say(fmt::format("  {} captures are left", controller_.captures().size()));
        ask();
        return {};
    }

    // Continues after the end of keyboard input: resting the pen captures the remaining heights,
    // and a movement lasts until the devices end.
    Result<void> go_on_alone()
    {
        if (takes_captures(controller_.procedure()))
            return next_height() ? Result<void>() : finish();
        return is_moving_ ? Result<void>() : enter(options_.now());
    }

    Result<void> finish()
    {
        if (!controller_.refusal().empty())
            TRY(command(options_.now(), "undo")); // Withdraws the refused capture.
        if (!takes_captures(controller_.procedure()))
            TRY(command(options_.now(), "end"));
        is_done_ = TRY(may_finish());
        return {};
    }

    void ask()
    {
        if (!takes_captures(controller_.procedure()))
            person_.say(is_moving_ ? fmt::format("{}; Enter when you are done",
                                                 movement_words(controller_.procedure()).during)
                                   : fmt::format("{}, then press Enter",
                                                 movement_words(controller_.procedure()).before));
        else if (auto const height = next_height())
            person_.say(fmt::format("Set the surface to {} mm and let it rest; Enter, or rest the "
                                    "pen on the tablet",
                                    *height));
        else
            person_.say("Set the surface to a height, let it rest, type the millimetres and Enter");
    }

    void show()
    {
        auto const now = options_.now();
        if (now - shown_ < kShowEvery)
            return;
        shown_ = now;
        auto const waiting = was_capturing_ ? "capturing …" : entry_.empty() ? "" : entry_ + " mm";
        person_.show(fmt::format("{}   [Enter, {}f done, q quit] {}", describe_reading(controller_),
                                 takes_captures(controller_.procedure()) ? "u undo, " : "",
                                 waiting));
    }

    CalibrationController& controller_;
    devices::LiveDevices& devices_;
    CalibrationPerson const& person_;
    LiveCalibrationOptions const& options_;
    std::vector<devices::LiveReport> reports_;
    std::string entry_;
    std::string typed_; // Keys typed during a capture.
    // Heights to capture again, as their first captures disagreed with the others.
    std::vector<double> again_mm_;
    bool was_capturing_ = false;
    Timestamp capture_began_ {};
    bool is_moving_ = false;
    bool is_asking_cause_ = false; // True while the user is asked why heights are off.
    bool is_done_ = false;
    bool is_away_ = false;
    Timestamp newest_ {}; // Time of the newest report.
    Timestamp shown_ {};
};

} // namespace

Result<bool> calibrate_live(CalibrationController& controller, devices::LiveDevices& devices,
                            CalibrationPerson const& person, LiveCalibrationOptions const& options,
                            std::atomic<bool> const& stop)
{
    return Conversation(controller, devices, person, options).run(stop);
}

MovementInstructions movement_words(CalibrationProcedure procedure)
{
    if (procedure == CalibrationProcedure::Tilt)
        return { .before = "Set the nib in a small dent that does not move on the tablet",
                 .during
                 = "Lean the pen slowly all around, as far as it goes, the nib in its dent" };
    return { .before = "Hold the pen on the tablet and against the edge",
             .during = "Move the surface up and down with the pen against the edge" };
}

static std::string describe_lean(CalibrationController const& controller)
{
    auto const& pen = controller.pen();
    if (!pen)
        return "no pen yet";
    if (!pen->tilt_rad)
        return "the pen tells no tilt";
    double const right_deg = degrees(pen->tilt_rad->x());
    double const away_deg = degrees(pen->tilt_rad->y());
    return fmt::format("leans {:.0f} degrees {}, {:.0f} {}, {} touches", std::abs(right_deg),
                       right_deg < 0 ? "left" : "right", std::abs(away_deg),
                       away_deg < 0 ? "towards you" : "away", controller.touches());
}

std::string describe_reading(CalibrationController const& controller)
{
    if (!needs_height(controller.procedure()))
        return describe_lean(controller);
    auto const reading = controller.reading();
    if (!reading)
        return "no reading yet";
    auto const volts = drivers::sensor_volts(controller.sensor().name, reading->counts);
    auto text = fmt::format("{:.1f} counts ({}), noise {:.1f}", reading->counts,
                            volts ? fmt::format("{:.3f} V", *volts)
                                  : fmt::format("{:.1f} % of full scale",
                                                100 * reading->counts / reading->full_scale_counts),
                            reading->noise_counts);
    if (reading->is_on_rail)
        text += ", AT THE CONVERTER'S END";
    else
        text += reading->is_at_rest ? ", at rest" : ", moving";
    if (controller.rig().calibration.height)
        if (auto const height = calib::height_mm(controller.rig().height_model, reading->counts))
            text += fmt::format(", {:.1f} mm so far", *height);
    if (!takes_captures(controller.procedure()))
        text += fmt::format(", {} touches", controller.touches());
    return text;
}

} // namespace tractus::calibration
