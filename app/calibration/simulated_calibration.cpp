#include "app/calibration/simulated_calibration.h"

#include "app/calibration/log_calibration.h"
#include "drivers/logs/log_writer.h"

#include <fmt/core.h>
#include <string>

namespace tractus::calibration {

namespace {

// Time from when the pen comes to rest until the capture.
constexpr Duration kCaptureDelay = std::chrono::milliseconds(700);

struct Command {
    Timestamp time {};
    std::string words;
};

// What the simulated user does: pen strokes, and commands.
struct Performance {
    std::vector<sim::HandStroke> strokes;
    std::vector<std::string> words; // The user's commands; for captures, one per stroke.
};

// Returns a stroke of a pen held still for two seconds: a line too short and slow to count as a
// movement.
sim::HandStroke hold_still(double height_mm)
{
    return { .path
             = sim::make_path(sim::LineShape { { 20, -10, height_mm }, { 22, -10, height_mm } }),
             .speed_mm_s = 1 };
}

// Returns a stroke of a nib held in a dent: a line of a tenth of a millimetre.
sim::HandStroke stay_in_dent(double height_mm, double seconds)
{
    constexpr double kDent_mm = 0.1;
    return { .path = sim::make_path(
                 sim::LineShape { { 20, -10, height_mm }, { 20 + kDent_mm, -10, height_mm } }),
             .speed_mm_s = kDent_mm / seconds };
}

sim::HandOptions hand_of(SimulatedCalibration const& calibration)
{
    sim::HandOptions options { .seed = calibration.person.seed, .height_tremor_mm = 0.02 };
    if (calibration.procedure == CalibrationProcedure::Tilt) {
        // The tremor is small, as the nib is held in a dent while the pen is leaned.
        options.plane_tremor_mm = 0.03;
        options.tilt_rad = Vec2::Zero();
        options.leaned_around_rad = Vec2(0.7, 0.6);
    }
    return options;
}

Performance captures(SimulatedCalibration const& calibration)
{
    auto const aimed_mm = calibration.heights_mm.empty()
        ? proposed_heights_mm(calibration.procedure)
        : calibration.heights_mm;
    Performance performance;
    for (auto const& height : sim::set_heights(aimed_mm, calibration.person)) {
        performance.strokes.push_back(hold_still(height.true_mm));
        performance.words.push_back(fmt::format("capture {}", height.stated_mm));
    }
    return performance;
}

Performance follow_edge(Vec3 const& low_mm, Vec3 const& high_mm)
{
    constexpr int kTimes = 4;
    constexpr double kSpeed_mm_s = 180;
    Performance performance;
    for (int i = 0; i < kTimes; ++i) {
        performance.strokes.push_back({ .path = sim::make_path(sim::LineShape { low_mm, high_mm }),
                                        .speed_mm_s = kSpeed_mm_s });
        performance.strokes.push_back({ .path = sim::make_path(sim::LineShape { high_mm, low_mm }),
                                        .speed_mm_s = kSpeed_mm_s });
    }
    return performance;
}

Performance perform(SimulatedCalibration const& calibration)
{
    constexpr double kLeaning_s = 20;
    double const top_mm = calibration.geometry.travel_mm - 20;
    switch (calibration.procedure) {
    case CalibrationProcedure::Travel:
        return follow_edge({ 10, 5, 20 }, { 10, 5, top_mm });
    case CalibrationProcedure::Tilt:
        return { .strokes = { stay_in_dent(60, kLeaning_s) }, .words = {} };
    case CalibrationProcedure::Latency:
        return follow_edge({ -70, -20, 60 }, { 70, 20, 60 + 0.6 * top_mm });
    default:
        return captures(calibration);
    }
}

std::vector<Command> commands_of(Performance const& performance, sim::Hand const& hand)
{
    std::vector<Command> commands;
    for (std::size_t i = 0; i < performance.words.size(); ++i)
        commands.push_back({ hand.strokes()[i].down + kCaptureDelay, performance.words[i] });
    if (performance.words.empty()) {
        commands.push_back({ hand.strokes().front().chosen, "begin" });
        commands.push_back({ hand.strokes().back().up, "end" });
    }
    return commands;
}

Result<void> check_heights(Performance const& performance, sim::RigGeometry const& geometry)
{
    for (auto const& stroke : performance.strokes) {
        double const height_mm = stroke.path.points_mm().front().z();
        double const counts = sim::ideal_counts(geometry, height_mm);
        if (height_mm < -geometry.string_base_mm || counts < 0
            || counts > geometry.full_scale_counts)
            return fail(Fault::User,
                        fmt::format("the simulated rig has no height of {:.0f} mm: it travels from "
                                    "0 to {} mm",
                                    height_mm, geometry.travel_mm));
    }
    return {};
}

} // namespace

std::vector<double> proposed_heights_mm(CalibrationProcedure procedure)
{
    switch (procedure) {
    case CalibrationProcedure::Height:
        return { 0, 60, 200, 400, 300, 120, 20 };
    case CalibrationProcedure::Check:
        return { 40, 90, 160, 250, 350 };
    case CalibrationProcedure::Zero:
        return { 0 };
    default:
        return {};
    }
}

sim::RigGeometry simulated_geometry(CalibrationProcedure procedure)
{
    sim::RigGeometry geometry;
    geometry.travel_shear = { 0.012, -0.007 };
    if (procedure == CalibrationProcedure::Tilt)
        geometry.coil_height_mm = 9;
    return geometry;
}

Result<void> write_simulated_calibration(std::ostream& out, SimulatedCalibration const& calibration)
{
    auto const performance = perform(calibration);
    TRY(check_heights(performance, calibration.geometry));
    sim::Hand const hand(performance.strokes, hand_of(calibration));
    sim::SimulatedRigOptions options { .geometry = calibration.geometry,
                                       .seed = calibration.person.seed };
    options.height.noise_counts = calibration.person.noise_counts;
    if (calibration.procedure == CalibrationProcedure::Tilt)
        options.tablet.tilt_noise_deg = 0.5;
    auto const run = sim::simulate_rig(hand, options);

    drivers::LogWriter log(out, { .devices = { run.tablet.info, run.height.info } });
    auto const commands = commands_of(performance, hand);
    std::size_t next = 0;
    for (auto const& arrived : run.in_order_of_arrival()) {
        for (; next < commands.size() && commands[next].time <= arrived.report->received; ++next)
            log.write_tool(commands[next].time, kCalibrateTool, commands[next].words);
        log.write_report(arrived.device, arrived.report->received, arrived.report->bytes());
    }
    return log.flush();
}

} // namespace tractus::calibration
