#include "app/methods/sketch_lsystem/sketch_report.h"

#include "app/document/model_cost.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"

#include <nlohmann/json.hpp>

namespace tractus::sketch {

Result<std::string> print_report(Rule const& rule, DrawnAxis const& axis, Model const& model)
{
    auto report = nlohmann::json { { "segments", axis.segments() }, { "depth", axis.depth } };
    for (auto const& node_mm : nodes_of(axis, rule))
        report["nodes"].push_back({ node_mm.x(), node_mm.y(), node_mm.z() });
    for (auto const* const key : { "plane", "bend", "counts" })
        report[key] = nlohmann::json::array();
    for (auto const& turn : axis.turns) {
        report["plane"].push_back(turn.plane_deg);
        report["bend"].push_back(turn.bend_deg);
    }
    auto const run = load_options();
    DeriveOptions options { .limits = run.limits, .print = run.print };
    options.on_step = [&](int step, ModuleString const& string) {
        if (step > 0)
            report["counts"].push_back(count_symbols(model, string));
    };
    TRY(derive(model, options));
    return report.dump() + "\n";
}

} // namespace tractus::sketch
