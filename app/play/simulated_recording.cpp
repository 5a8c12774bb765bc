#include "app/play/simulated_recording.h"

#include "app/tools/min_extent.h"
#include "app/tools/tool.h"
#include "calib/rig_file.h"
#include "drivers/logs/log_writer.h"
#include "engine/plant/join_axes.h"
#include "sim/simulated_rig.h"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <variant>

namespace tractus::play {

namespace {

// Returns an axis as the selection view shows it, without its two ends. At its base the pen would
// touch the parent first, and beyond its tip nothing.
Result<std::vector<Vec2>> shown_axis(Plant const& plant, Vec2 const& tablet_size_mm,
                                     std::size_t rank)
{
    auto const order = axes_in_drawing_order(plant);
    if (rank >= order.size())
        return fail(Fault::User,
                    fmt::format("the plant has no branch {}: it has {}", rank, order.size()));
    auto const view = scene::fit_selection_view(plant, { .area_mm = tablet_size_mm });
    auto const nodes = plant.positions(plant.axes[order[rank]]);
    auto const between = [&](std::size_t from, std::size_t to) {
        Vec2 const middle
            = (view.tablet_of_plant(nodes[from]) + view.tablet_of_plant(nodes[to])) / 2;
        return Vec2(middle + tablet_size_mm / 2);
    };
    std::vector<Vec2> points;
    points.push_back(between(0, 1));
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        points.push_back(view.tablet_of_plant(nodes[i]) + tablet_size_mm / 2);
    if (nodes.size() > 2)
        points.push_back(between(nodes.size() - 2, nodes.size() - 1));
    else
        points.push_back(view.tablet_of_plant(nodes.back()) + tablet_size_mm / 2);
    return points;
}

void write_reports(drivers::LogWriter& log, sim::SimulatedRun const& run, sim::Hand const& hand,
                   sim::GestureScript const& script, tools::ToolKinds tools)
{
    auto const write_tool = [&](Timestamp time, sim::Gesture const& gesture) {
        log.write_tool(time, gesture.tool,
                       script.tools == sim::GestureScript::Tools::Older
                           ? gesture.words
                           : tools::words_of_selected_tool(tools, gesture.tool, gesture.words));
    };
    if (script.unkindness.dab_share > 0)
        log.write_tool({}, std::string(tools::kMinExtentsLine),
                       tools::print_min_extents(tools::usual_min_extents(tools)));
    auto gesture = script.gestures.begin();
    std::size_t stroke = 0;
    // An action without a stroke is written at the time at which the hand selects the tool of the
    // next stroke.
    auto const write_tools_until = [&](Timestamp time) {
        for (; stroke < hand.strokes().size() && hand.strokes()[stroke].chosen <= time; ++stroke) {
            if (stroke > 0 && hand.is_dab(stroke - 1))
                // The previous stroke was a dab, made with the tool of this stroke; no tool was
                // selected between them.
                continue;
            for (bool draws = false; !draws; ++gesture) {
                draws = !std::holds_alternative<sim::AtOnce>(gesture->path);
                write_tool(hand.strokes()[stroke].chosen, *gesture);
            }
        }
    };
    Timestamp last {};
    for (auto const& arrived : run.in_order_of_arrival()) {
        last = arrived.report->received;
        write_tools_until(last);
        log.write_report(arrived.device, last, arrived.report->bytes());
    }
    for (; gesture != script.gestures.end(); ++gesture)
        write_tool(last, *gesture);
}

Result<void> check_tools(sim::GestureScript const& script, tools::ToolKinds tools)
{
    if (tools.empty())
        return {};
    for (auto const& gesture : script.gestures)
        if (auto const tool = tools::parse_tool(tools, gesture.tool, gesture.words); !tool)
            return fail(tool.error().fault,
                        fmt::format("{}: {}", gesture.place, tool.error().message));
    return {};
}

} // namespace

Result<sim::Hand> simulated_hand(sim::GestureScript const& script, scene::Scene const& scene)
{
    auto const geometry = sim::SimulatedRigOptions().geometry;
    auto const tracer
        = [&](std::size_t rank) { return shown_axis(*scene.base, geometry.tablet_size_mm, rank); };
    sim::HandOptions options;
    options.seed = script.seed;
    if (script.lean_deg)
        options.tilt_rad = *script.lean_deg * (kPi / 180);
    options.leaned_around_rad = script.leaned_around_deg * (kPi / 180);
    sim::set_tremor(options, script.unkindness);
    return sim::Hand(TRY(sim::strokes_of(script, geometry, tracer)), options);
}

Result<void> write_simulated_recording(std::ostream& out, sim::GestureScript const& script,
                                       scene::Scene const& scene, tools::ToolKinds tools)
{
    TRY(check_tools(script, tools));
    sim::SimulatedRigOptions options;
    options.seed = script.seed;
    options.geometry.coil_height_mm = script.coil_height_mm;
    auto const hand = TRY(simulated_hand(script, scene));
    auto run = sim::simulate_rig(hand, options);
    sim::make_unkind(run, script.unkindness);
    if (script.unkindness.delays_reports())
        run.rig.sample_times = calib::SampleTimes::Evened;

    drivers::LogHeader header;
    header.devices = { run.tablet.info, run.height.info };
    header.rig_text = calib::print_rig(run.rig);
    drivers::LogWriter log(out, header);
    write_reports(log, run, hand, script, tools);
    return log.flush();
}

} // namespace tractus::play
