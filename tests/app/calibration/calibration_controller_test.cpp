#include "app/calibration/calibration_controller.h"

#include "app/calibration/live_calibration.h"
#include "app/calibration/log_calibration.h"
#include "app/calibration/simulated_calibration.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "tests/app/simple_rig.h"
#include "tests/corpus.h"

#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>

namespace tractus::calibration {
namespace {

constexpr auto kDate = "2026-11-21";

std::string simulated_text(SimulatedCalibration calibration)
{
    calibration.geometry = simulated_geometry(calibration.procedure);
    std::ostringstream text;
    EXPECT_TRUE(write_simulated_calibration(text, calibration));
    return text.str();
}

Result<CalibrationOutcome> outcome_of(std::string const& text, CalibrationProcedure procedure,
                                      calib::Rig const& rig = {})
{
    auto const log = drivers::parse_log(text, "my.tractus-log").value();
    return calibrate_from_log(log, { .procedure = procedure, .rig = rig }, kDate);
}

Result<CalibrationOutcome> outcome_with(CalibrationController::Options options,
                                        std::string const& text)
{
    auto const log = drivers::parse_log(text, "my.tractus-log").value();
    return calibrate_from_log(log, std::move(options), kDate);
}

std::string refusal_of(std::string const& text,
                       CalibrationProcedure procedure = CalibrationProcedure::Height)
{
    auto const outcome = outcome_of(text, procedure);
    return outcome ? "no error" : outcome.error().message;
}

// Returns a rig calibrated by the simulated person.
calib::Rig calibrated_rig()
{
    return outcome_of(simulated_text({}), CalibrationProcedure::Height).value().rig;
}

TEST(CalibrationController, CalibratesTheSimulatedRigsHeight)
{
    auto const rig = calibrated_rig();
    auto const truth = sim::true_rig(simulated_geometry());
    for (double counts = rig.calibrated_min_counts; counts < rig.calibrated_max_counts;
         counts += 50)
        EXPECT_NEAR(calib::height_mm(rig.height_model, counts).value(),
                    calib::height_mm(truth.height_model, counts).value(), 1.2);
    EXPECT_EQ(rig.calibration.height->captures.size(), 7u);
    EXPECT_EQ(rig.calibration.height->sensor.name, "Simulated height sensor");
    EXPECT_EQ(rig.calibration.height->sensor.id, "0006:0000:0002");
    EXPECT_EQ(rig.tablet_size_mm, Vec2(254, 159));
}

TEST(CalibrationController, GivesTheSameRigFromTheSameLog)
{
    auto const text = simulated_text({});
    EXPECT_EQ(calib::print_rig(outcome_of(text, CalibrationProcedure::Height).value().rig),
              calib::print_rig(outcome_of(text, CalibrationProcedure::Height).value().rig));
}

TEST(CalibrationController, FitsAgainWhatARigFileKept)
{
    auto const rig = calib::parse_rig(calib::print_rig(calibrated_rig()), "my.rig.toml").value();
    auto const again = calib::refit_height(rig).value();
    Eigen::VectorXd const difference
        = calib::parameters_of(again.model) - calib::parameters_of(rig.height_model);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CalibrationController, FindsTravelAndLatency)
{
    auto rig = calibrated_rig();
    auto const travel = outcome_of(simulated_text({ .procedure = CalibrationProcedure::Travel }),
                                   CalibrationProcedure::Travel, rig)
                            .value();
    EXPECT_NEAR(travel.rig.travel_shear.x(), 0.012, 0.002);
    EXPECT_NEAR(travel.rig.travel_shear.y(), -0.007, 0.002);
    EXPECT_NEAR(travel.rig.calibration.travel->tilt_deg,
                degrees(std::atan(std::hypot(0.012, 0.007))), 0.1);
    auto const latency = outcome_of(simulated_text({ .procedure = CalibrationProcedure::Latency }),
                                    CalibrationProcedure::Latency, travel.rig)
                             .value();
    EXPECT_NEAR(1000 * to_seconds(latency.rig.tablet_latency - latency.rig.height_latency), 5, 0.5);
}

// The simulated tablet senses the pen's coil, which is 9 mm above the nib.
TEST(CalibrationController, FindsWhereTheTabletSeesThePen)
{
    auto const text = simulated_text({ .procedure = CalibrationProcedure::Tilt });
    auto const outcome = outcome_of(text, CalibrationProcedure::Tilt, calibrated_rig()).value();
    EXPECT_NEAR(outcome.rig.coil_height_mm.x(), 9, 0.1);
    EXPECT_NEAR(outcome.rig.coil_height_mm.y(), 9, 0.1);
    EXPECT_EQ(outcome.rig.calibration.tilt->date, kDate);
    EXPECT_NE(outcome.report.find(" mm above its nib to the left and right"), std::string::npos)
        << outcome.report;
}

TEST(CalibrationController, LeavesATabletAloneThatCorrectsForTilts)
{
    std::ostringstream text;
    ASSERT_TRUE(write_simulated_calibration(text, { .procedure = CalibrationProcedure::Tilt }));
    auto rig = calibrated_rig();
    rig.coil_height_mm = { 7, 7 };
    auto const outcome = outcome_of(text.str(), CalibrationProcedure::Tilt, rig).value();
    EXPECT_EQ(outcome.rig.coil_height_mm, Vec2(0, 0));
    EXPECT_NE(outcome.report.find("the tablet corrects for a pen that leans, so the rig does not"),
              std::string::npos)
        << outcome.report;
}

TEST(CalibrationController, FindsATiltWithoutAHeightSensor)
{
    auto const whole
        = drivers::parse_log(simulated_text({ .procedure = CalibrationProcedure::Tilt }),
                             "my.tractus-log")
              .value();
    auto controller = CalibrationController::create({ &whole.devices[0], 1 },
                                                    { .procedure = CalibrationProcedure::Tilt })
                          .value();
    for (auto const& record : whole.records)
        controller.push(record.device, record.time, whole.report(record));
    EXPECT_NE(describe_reading(controller).find("leans "), std::string::npos);
    EXPECT_NEAR(controller.finish(kDate).value().rig.coil_height_mm.x(), 9, 0.1);
}

TEST(CalibrationController, RefusesATiltOfATabletThatTellsNone)
{
    auto upright = drivers::simple_pen(); // The usages 3d (X tilt) and 3e (Y tilt) are replaced.
    for (auto& byte : upright.report_descriptor)
        if (byte == std::byte { 0x3d } || byte == std::byte { 0x3e })
            byte = std::byte { 0x00 };
    auto const refused = CalibrationController::create({ &upright, 1 },
                                                       { .procedure = CalibrationProcedure::Tilt });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "Simple Pen tells no tilt, so there is nothing to calibrate, and nothing that tips "
              "could be corrected by");
}

TEST(CalibrationController, QuotesHowExactARigIs)
{
    auto const outcome = outcome_of(simulated_text({ .procedure = CalibrationProcedure::Check }),
                                    CalibrationProcedure::Check, calibrated_rig())
                             .value();
    EXPECT_EQ(outcome.report.substr(0, 7), "within ");
    EXPECT_NE(outcome.report.find(" mm over 40–350 mm\n"), std::string::npos) << outcome.report;
    EXPECT_LE(outcome.rig.calibration.check->within_mm, 2);
}

// Returns a log in which the person says that the height is 0 while the surface is at 100 mm.
std::string zeroed_too_low()
{
    auto text = simulated_text({ .procedure = CalibrationProcedure::Zero, .heights_mm = { 100 } });
    return text.replace(text.find("capture 100"), 11, "capture 0");
}

TEST(CalibrationController, ZeroesATableThatMovedWithoutTouchingTheScale)
{
    auto const rig = calibrated_rig();
    auto const outcome = outcome_with({ .procedure = CalibrationProcedure::Zero,
                                        .rig = rig,
                                        .zero_cause = calib::ZeroCause::Moved },
                                      zeroed_too_low())
                             .value();
    EXPECT_NEAR(calib::height_mm(outcome.rig.height_model, 2000).value(),
                calib::height_mm(rig.height_model, 2000).value() - 100, 2);
    EXPECT_NEAR(calib::mm_per_count_at(outcome.rig.height_model, 2000).value(),
                calib::mm_per_count_at(rig.height_model, 2000).value(), 1e-9);
    EXPECT_NEAR(outcome.rig.calibration.height->raised_mm, -100, 2);
    EXPECT_EQ(outcome.report.find("if the table"), std::string::npos) << outcome.report;
}

TEST(CalibrationController, TakesAStringToHaveSlippedAndSaysWhatElseItMayBe)
{
    auto const rig = calibrated_rig();
    auto const outcome = outcome_of(zeroed_too_low(), CalibrationProcedure::Zero, rig).value();
    auto const& before = std::get<calib::StringHeight>(rig.height_model);
    auto const& after = std::get<calib::StringHeight>(outcome.rig.height_model);
    EXPECT_EQ(after.base_mm, before.base_mm);
    EXPECT_LT(after.zero_length_mm, before.zero_length_mm - 10);
    EXPECT_NE(outcome.report.find("  if the table, the spool's stand or the ruler moved instead, "
                                  "heights are up to "),
              std::string::npos)
        << outcome.report;
}

TEST(CalibrationController, RefusesASlippedCaptureThatTheOthersAreTooFewToOutvote)
{
    SimulatedCalibration slipped;
    slipped.person.slip = sim::Slip { .capture = 2, .wrong_by_mm = 20 };
    auto const text = simulated_text(slipped);
    EXPECT_EQ(refusal_of(text),
              "my.tractus-log: capture 3 (220 mm) disagrees with the others, which are too few to "
              "tell who is right: measure it again (--force keeps the fit all the same)");
    auto const outcome = outcome_with({ .is_forced = true }, text).value();
    EXPECT_EQ(outcome.rig.calibration.height->slipped, std::vector<std::size_t> { 2 });
    EXPECT_NE(outcome.report.find("capture 3 at 220 mm is off by +"), std::string::npos)
        << outcome.report;
    EXPECT_NE(outcome.report.find("  kept by force: capture 3 (220 mm)"), std::string::npos)
        << outcome.report;
}

TEST(CalibrationController, NamesASlippedCaptureOfManyInItsReport)
{
    SimulatedCalibration slipped { .heights_mm = { 0, 60, 200, 400, 300, 120, 20, 250, 350 } };
    slipped.person.slip = sim::Slip { .capture = 2, .wrong_by_mm = 20 };
    auto const outcome = outcome_of(simulated_text(slipped), CalibrationProcedure::Height).value();
    EXPECT_EQ(outcome.rig.calibration.height->slipped, std::vector<std::size_t> { 2 });
    EXPECT_NE(outcome.report.find("capture 3 at 220 mm is off by +"), std::string::npos)
        << outcome.report;
}

// Returns the log's text with one of its lines changed.
std::string with_line(std::string text, std::string_view from, std::string_view to)
{
    auto const place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

TEST(CalibrationController, UndoesACapture)
{
    auto const text = simulated_text({});
    auto const place = text.find("T: ", text.find("capture 60"));
    auto const time = text.substr(place, 13);
    auto const undone = std::string(text).insert(place, time + " calibrate undo\n");
    auto const rig = outcome_of(undone, CalibrationProcedure::Height).value().rig;
    EXPECT_EQ(rig.calibration.height->captures.size(), 6u);
    EXPECT_EQ(rig.calibration.height->captures[1].ruler_mm, 200);
}

TEST(CalibrationController, DropsACapture)
{
    auto const text = simulated_text({});
    auto const place = text.find("T: ", text.find("capture 200"));
    auto const time = text.substr(place, 16);
    auto const dropped = std::string(text).insert(place, time + " calibrate drop 1\n");
    auto const rig = outcome_of(dropped, CalibrationProcedure::Height).value().rig;
    EXPECT_EQ(rig.calibration.height->captures.size(), 6u);
    EXPECT_EQ(rig.calibration.height->captures[0].ruler_mm, 60);
    auto const none = std::string(text).insert(place, time + " calibrate drop 9\n");
    EXPECT_NE(refusal_of(none).find("\"9\" is no capture to drop: there are "), std::string::npos)
        << refusal_of(none);
}

TEST(CalibrationController, RefusesACaptureWhileTheSurfaceMoves)
{
    // Moves the capture command for 300 mm to a time at which the surface is still moving.
    auto const text = simulated_text({ .heights_mm = { 0, 300 } });
    auto const last = text.rfind("calibrate capture 300");
    auto const line = text.rfind('\n', last) + 1;
    auto const end = text.find('\n', last) + 1;
    auto const moved = text.substr(line, end - line);
    auto early = text.substr(0, line) + text.substr(end);
    auto const first = text.find("calibrate capture 0\n");
    auto const seconds = std::stod(text.substr(text.rfind("T: ", first) + 3));
    auto const time = seconds + 2.0;
    // The log must stay in order of time: the command goes before the first report that is later.
    std::size_t at = early.find("\nE: ") + 1;
    while (std::stod(early.substr(early.find("E: ", at) + 3)) < time)
        at = early.find("\nE: ", at) + 1;
    auto const too_early = fmt::format("T: {:013.6f} calibrate capture 300\n", time);
    early.insert(at, too_early);
    EXPECT_NE(refusal_of(early).find("my.tractus-log: the capture at 300 mm: the surface moved "
                                     "during the capture, by "),
              std::string::npos)
        << refusal_of(early);

    // If the capture is repeated later, the report still mentions the refused capture.
    auto const again = std::string(early).insert(line + too_early.size(), moved);
    auto const report = outcome_of(again, CalibrationProcedure::Height).value().report;
    EXPECT_NE(report.find("  not used: the capture at 300 mm: the surface moved during the "
                          "capture, by "),
              std::string::npos)
        << report;
}

TEST(CalibrationController, RefusesCommandsOutOfOrder)
{
    auto const text = simulated_text({ .heights_mm = { 0, 100 } });
    auto const second = text.rfind("T: ", text.find("calibrate capture 100"));
    auto changed = text;
    changed.replace(second, 16, "T: 000000.100000");
    EXPECT_NE(refusal_of(changed).find("captures are out of order, so the log was changed; record "
                                       "it again"),
              std::string::npos)
        << refusal_of(changed);
}

TEST(CalibrationController, RefusesWordsThatMeanNothing)
{
    auto const text = simulated_text({ .heights_mm = { 0, 100 } });
    EXPECT_EQ(refusal_of(with_line(text, "capture 100", "capture high")),
              "my.tractus-log: \"high\" is no height: give millimetres, such as 120.5");
    EXPECT_EQ(refusal_of(with_line(text, "capture 100", "jump")),
              "my.tractus-log: \"jump\" is no command of calibrate height: expected capture MM, "
              "undo or drop N");
}

TEST(CalibrationController, RefusesALogThatEndsTooEarly)
{
    auto const text = simulated_text({ .heights_mm = { 0, 100 } });
    auto const last = text.find('\n', text.find("calibrate capture 100"));
    EXPECT_EQ(refusal_of(text.substr(0, last + 1)),
              "my.tractus-log: the readings end before the capture at 100 mm does: check that the "
              "height sensor sends, then capture it again");
}

TEST(CalibrationController, RefusesALogWithoutCaptures)
{
    auto const text = simulated_text({ .procedure = CalibrationProcedure::Travel });
    EXPECT_NE(refusal_of(with_line(with_line(text, "calibrate begin", "x"), "calibrate end", "x"))
                  .find("no capture was given"),
              std::string::npos);
}

TEST(CalibrationController, RefusesTravelThatDoesNotMove)
{
    auto const text = simulated_text({ .heights_mm = { 100 } });
    auto const outcome = outcome_of(with_line(text, "calibrate capture 100", "x"),
                                    CalibrationProcedure::Travel, calibrated_rig());
    EXPECT_EQ(outcome.error().message.substr(0, 60),
              "my.tractus-log: the surface moved by only 0 mm while the pen");
    auto const latency = outcome_of(with_line(text, "calibrate capture 100", "x"),
                                    CalibrationProcedure::Latency, calibrated_rig());
    EXPECT_NE(latency.error().message.find("the surface moved by only 0 mm"), std::string::npos);
}

TEST(CalibrationController, RefusesLatencyAlongAnUprightEdge)
{
    auto const text = simulated_text({ .procedure = CalibrationProcedure::Travel });
    auto const outcome = outcome_of(text, CalibrationProcedure::Latency, calibrated_rig());
    EXPECT_FALSE(outcome);
    EXPECT_NE(outcome.error().message.find("inclin"), std::string::npos) << outcome.error().message;
}

TEST(CalibrationController, RefusesAnotherConverterThanTheRigs)
{
    auto rig = calibrated_rig();
    rig.full_scale_counts = 1023;
    auto const outcome = outcome_of(simulated_text({ .procedure = CalibrationProcedure::Check }),
                                    CalibrationProcedure::Check, rig);
    EXPECT_EQ(outcome.error().message,
              "my.tractus-log: the height sensor reads up to 4095 and the rig was calibrated with "
              "one up to 1023: connect that one, or calibrate the height anew");
}

TEST(CalibrationController, NeedsASensor)
{
    EXPECT_EQ(CalibrationController::create({}, {}).error().message,
              "there is no height sensor to calibrate: connect it, or name it with --device");
}

// Without keyboard and mouse, the capture is triggered by resting the pen on the tablet.
TEST(LiveCalibration, CapturesWhenThePenRestsAndRecordsWhatGivesTheSameRig)
{
    std::ostringstream text;
    SimulatedCalibration simulated { .heights_mm = { 0, 150 } };
    ASSERT_TRUE(write_simulated_calibration(text, simulated));
    auto const played = drivers::parse_log(text.str(), "played").value();

    // All reports of the log are played without waiting; the clock is the time of the newest
    // report.
    auto controller = CalibrationController::create(played.devices, {}).value();
    Timestamp now {};
    std::size_t next = 0;
    std::ostringstream recorded_text;
    drivers::LogWriter recorder(recorded_text, { .devices = played.devices });
    std::size_t captured = 0;
    for (; next < played.records.size(); ++next) {
        auto const& record = played.records[next];
        now = record.time;
        controller.push(record.device, record.time, played.report(record));
        recorder.write_report(record.device, record.time, played.report(record));
        if (controller.take_pen_rest() && captured < simulated.heights_mm.size()) {
            auto const words = fmt::format("capture {}", simulated.heights_mm[captured++]);
            ASSERT_TRUE(controller.command(now, words));
            recorder.write_tool(now, kCalibrateTool, words);
        }
    }
    ASSERT_TRUE(recorder.flush());
    auto const live = controller.finish(kDate).value();
    EXPECT_EQ(live.rig.calibration.height->captures.size(), 2u);
    EXPECT_EQ(
        calib::print_rig(outcome_of(recorded_text.str(), CalibrationProcedure::Height).value().rig),
        calib::print_rig(live.rig));
}

// Pushes a report of the pen every 10 ms, in which it touches the tablet or hovers above it.
void hold_pen(CalibrationController& controller, int from_ms, int to_ms, bool touching)
{
    for (int time_ms = from_ms; time_ms < to_ms; time_ms += 10)
        controller.push(kPen, at_ms(time_ms), pen_report(50, 50, touching));
}

TEST(CalibrationController, CountsATouchThatPressesForNothing)
{
    auto controller
        = CalibrationController::create(simple_rig(), { .procedure = CalibrationProcedure::Travel })
              .value();
    ASSERT_TRUE(controller.command(at_ms(0), "begin"));
    hold_pen(controller, 0, 100, true);
    hold_pen(controller, 100, 150, false);
    hold_pen(controller, 150, 200, true);
    EXPECT_EQ(controller.touches(), 15u);
    ASSERT_TRUE(controller.command(at_ms(200), "press"));
    EXPECT_EQ(controller.touches(), 10u) << "of the touch from its beginning on";
    hold_pen(controller, 200, 250, true);
    EXPECT_EQ(controller.touches(), 10u) << "to its end";
    hold_pen(controller, 250, 300, false);
    hold_pen(controller, 300, 330, true);
    EXPECT_EQ(controller.touches(), 13u) << "and not of the next one";
}

TEST(CalibrationController, TakesATouchThatPressesForNoRest)
{
    auto controller = CalibrationController::create(simple_rig(), {}).value();
    hold_pen(controller, 0, 50, true);
    ASSERT_TRUE(controller.command(at_ms(50), "press"));
    hold_pen(controller, 50, 1000, true);
    EXPECT_FALSE(controller.take_pen_rest());
    hold_pen(controller, 1000, 1100, false);
    hold_pen(controller, 1100, 2000, true);
    EXPECT_TRUE(controller.take_pen_rest());
}

// The sensor sends no report between the capture at 60 mm and the next one.
TEST(CalibrationController, SaysThatTheSensorFellSilentDuringACapture)
{
    std::istringstream lines(simulated_text({}));
    std::string text;
    bool is_unplugged = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("T: "))
            is_unplugged = line.ends_with("capture 60");
        if (!is_unplugged || !line.starts_with("E: "))
            text += line + "\n";
    }
    EXPECT_NE(refusal_of(text).find("the height sensor fell silent during the capture at 60 mm"),
              std::string::npos)
        << refusal_of(text);
}

// The sensor is unplugged during the capture at 60 mm, and sends reports again before the next
// capture.
TEST(CalibrationController, SaysThatTheSensorWasUnpluggedDuringACapture)
{
    std::istringstream lines(simulated_text({}));
    std::string with_unplugging;
    std::string with_silence;
    int since_capture = -1; // Number of reports since the capture began; -1: not begun.
    // Reports before the unplugging; both devices send some 700 a second.
    constexpr int kBefore = 200;
    constexpr int kAway = 700;
    std::string device = "D: 0"; // The log's current device line.
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("D: "))
            device = line;
        if (line.ends_with("capture 60"))
            since_capture = 0;
        bool const is_report = line.starts_with("E: ");
        if (since_capture >= 0 && is_report && ++since_capture == kBefore)
            with_unplugging
                += "D: 1\nG: " + line.substr(3, line.find(' ', 3) - 3) + "\n" + device + "\n";
        if (is_report && since_capture >= kBefore && since_capture < kBefore + kAway)
            continue;
        with_unplugging += line + "\n";
        with_silence += line + "\n";
    }
    for (auto const& [text, reason] :
         { std::pair(with_unplugging, "was unplugged during it: plug it in, then capture"),
           std::pair(with_silence, "from within it: was it unplugged?") }) {
        auto const log = drivers::parse_log(text, "my.tractus-log").value();
        auto const outcome = calibrate_from_log(log, {}, kDate);
        ASSERT_TRUE(outcome) << outcome.error().message;
        auto const at = outcome->report.find("not used: the capture at 60 mm: the height sensor");
        ASSERT_NE(at, std::string::npos) << outcome->report;
        EXPECT_NE(outcome->report.find(reason, at), std::string::npos) << outcome->report;
    }
}

// The log has five captures with a vertical string. An earlier version fitted a string to these
// readings that ended at the lowest capture.
TEST(PlumbStringLog, GivesARigThatIsReadAndHasAllHeights)
{
    REQUIRE_CORPUS();
    auto const log = drivers::read_log(corpus() / "faults" / "unreadable.tractus-log").value();
    auto const outcome = calibrate_from_log(log, {}, kDate).value();
    auto const rig = calib::parse_rig(calib::print_rig(outcome.rig), "my.rig.toml").value();
    for (double height_mm = -39; height_mm <= 439; height_mm += 1) {
        auto const counts = calib::counts_at_height(rig.height_model, height_mm);
        ASSERT_TRUE(counts) << height_mm;
        EXPECT_NEAR(calib::height_mm(rig.height_model, *counts).value_or(-1e9), height_mm, 1e-3);
    }
}

} // namespace
} // namespace tractus::calibration
