#include "app/calibration/live_calibration.h"

#include "app/calibration/log_calibration.h"
#include "drivers/sensors/sensor_volts.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr Duration kRest = std::chrono::milliseconds(2);
constexpr Duration kShowEvery = std::chrono::milliseconds(100);
constexpr char kEndOfInput = '\4';
constexpr char kBackspace = '\b';
constexpr char kDelete = '\177';

// As a log writes it: microseconds since its start.
Timestamp time_in_log(Timestamp time, Timestamp start)
{
    auto const since = std::max(time - start, Duration {});
    return Timestamp(std::chrono::duration_cast<std::chrono::microseconds>(since));
}

class Conversation {
public:
    Conversation(CalibrationController& controller, LiveDevices& devices,
                 CalibrationPerson const& person, LiveCalibrationOptions const& options)
        : controller_(controller)
        , devices_(devices)
        , person_(person)
        , options_(options)
    {
        if (!takes_captures(controller.procedure()))
            is_moving_ = false;
    }

    // False when the person went away.
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
                options_.rest(kRest);
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
            if (report.report.size == 0)
                continue;
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
        if (was_capturing_) {
            if (!controller_.is_capturing())
                TRY(tell_capture());
            return {}; // Keys wait until the capture is over.
        }
        if (takes_captures(controller_.procedure()) && controller_.take_pen_rest() && next_height())
            return enter(newest_); // However late we notice it.
        if (auto const key = person_.key())
            return press(*key);
        return {};
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
            return {}; // An empty line.
        TRY(command(time, "capture " + *height));
        entry_.clear();
        was_capturing_ = controller_.is_capturing();
        return {};
    }

    // What was typed, else the next of the list.
    std::optional<std::string> next_height() const
    {
        if (!entry_.empty())
            return entry_;
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
        bool const is_last = !options_.heights_mm.empty()
            && controller_.captures().size() >= options_.heights_mm.size();
        is_done_ = is_last || controller_.procedure() == CalibrationProcedure::Zero;
        if (!is_done_)
            ask();
        return {};
    }

    Result<void> undo()
    {
        if (!takes_captures(controller_.procedure()))
            return {};
        TRY(command(options_.now(), "undo"));
        person_.say(fmt::format("  {} captures are left", controller_.captures().size()));
        ask();
        return {};
    }

    // Nobody says anything more: the pen's rest captures the heights that are left, and a movement
    // is all that the devices send.
    Result<void> go_on_alone()
    {
        if (takes_captures(controller_.procedure()))
            return next_height() ? Result<void>() : finish();
        return is_moving_ ? Result<void>() : enter(options_.now());
    }

    Result<void> finish()
    {
        if (!controller_.refusal().empty())
            TRY(command(options_.now(), "undo")); // The refused capture is not wanted any more.
        if (!takes_captures(controller_.procedure()))
            TRY(command(options_.now(), "end"));
        is_done_ = true;
        return {};
    }

    void ask()
    {
        if (!takes_captures(controller_.procedure()))
            person_.say(is_moving_ ? "Move the surface up and down; Enter when you are done"
                                   : "Hold the pen against the edge, then press Enter");
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
    LiveDevices& devices_;
    CalibrationPerson const& person_;
    LiveCalibrationOptions const& options_;
    std::vector<LiveReport> reports_;
    std::string entry_;
    bool was_capturing_ = false;
    bool is_moving_ = false;
    bool is_done_ = false;
    bool is_away_ = false;
    Timestamp newest_ {}; // Of the reports.
    Timestamp shown_ {};
};

} // namespace

Result<bool> calibrate_live(CalibrationController& controller, LiveDevices& devices,
                            CalibrationPerson const& person, LiveCalibrationOptions const& options,
                            std::atomic<bool> const& stop)
{
    return Conversation(controller, devices, person, options).run(stop);
}

std::string describe_reading(CalibrationController const& controller)
{
    auto const reading = controller.reading();
    if (!reading)
        return "no reading yet";
    auto const volts = sensor_volts(controller.sensor().name, reading->counts);
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
        if (auto const height = height_mm(controller.rig().height_model, reading->counts))
            text += fmt::format(", {:.1f} mm so far", *height);
    if (!takes_captures(controller.procedure()))
        text += fmt::format(", {} touches", controller.touches());
    return text;
}

} // namespace tractus
