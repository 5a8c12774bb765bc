#include "app/methods/construction_lines/construct_report.h"

#include "engine/methods/construction_lines/line_model.h"

#include <nlohmann/json.hpp>

namespace tractus::lines {

using Report = nlohmann::ordered_json;

static Report print_functions(Construction const& construction)
{
    constexpr int kPlaces = 21;
    Report functions;
    for (int i = 0; i < kPlaces; ++i) {
        auto const values = values_at(construction, static_cast<double>(i) / (kPlaces - 1));
        functions["heading"].push_back(values.heading_deg);
        functions["depth"].push_back(values.pitch_deg);
        functions["alpha"].push_back(values.left_deg);
        functions["beta"].push_back(values.right_deg);
        functions["left_size"].push_back(values.left_size);
        functions["right_size"].push_back(values.right_size);
    }
    return functions;
}

std::string print_report(Construction const& construction, Plant const& plant,
                         std::vector<std::string> const& roles)
{
    Report lines = Report::array();
    for (auto const& line : construction.inclinations)
        lines.push_back(line.x);
    Report node_x = Report::array();
    for (auto const& node : construction.nodes)
        node_x.push_back(node.x);
    Report leaf_tips = Report::array();
    for (auto const& tip : organ_tips(construction, plant))
        leaf_tips.push_back({ tip.x(), tip.y(), tip.z() });
    Report report { { "stem_length", construction.stem.length_mm() },
                    { "lines", lines },
                    { "d1", construction.below() },
                    { "d2", construction.above() },
                    { "node_x", node_x },
                    { "functions", print_functions(construction) },
                    { "leaf_tips", leaf_tips },
                    { "notes", construction.notes } };
    if (!roles.empty())
        report["roles"] = roles;
    return report.dump() + "\n";
}

} // namespace tractus::lines
