#include "app/methods/sketch_lsystem/sketch_report.h"

#include "app/document/model_cost.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"

#include <nlohmann/json.hpp>

namespace tractus::sketch {

Result<std::string> print_report(ReportedAxis const& drawn, lsystem::Model const& model,
                                 std::uint64_t seed)
{
    auto report = nlohmann::json { { "segments", drawn.axis.segments() } };
    if (drawn.depth)
        report["depth"] = *drawn.depth;
    for (auto const& node_mm : drawn.nodes_mm)
        report["nodes"].push_back({ node_mm.x(), node_mm.y(), node_mm.z() });
    for (auto const* const key : { "plane", "bend", "counts" })
        report[key] = nlohmann::json::array();
    for (auto const& turn : drawn.axis.turns) {
        report["plane"].push_back(turn.plane_deg);
        report["bend"].push_back(turn.bend_deg);
    }
    auto const run = document::load_options();
    lsystem::DeriveOptions options { .seed = seed, .limits = run.limits, .print = run.print };
    options.on_step = [&](int step, lsystem::ModuleString const& string) {
        if (step > 0)
            report["counts"].push_back(lsystem::count_symbols(model, string));
    };
    TRY(lsystem::derive(model, options));
    return report.dump() + "\n";
}

} // namespace tractus::sketch
