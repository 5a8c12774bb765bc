#include "app/batch/plant_report.h"

#include "engine/plant/tree_measures.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tractus::batch {

std::string print_plant_report(Plant const& plant)
{
    auto const measures = measure_tree(plant);
    auto const thousandths = [](double value) { return std::round(value * 1000) / 1000; };
    auto const metres = [&](double value_mm) { return thousandths(value_mm / 1000); };
    nlohmann::ordered_json const report {
        { "internodes", measures.internodes },
        { "organs", plant.organs.size() },
        { "height_m", metres(measures.height_mm) },
        { "crown_width_m", metres(measures.crown_width_mm) },
        { "crown_base_m", metres(measures.crown_base_mm) },
        { "breast_diameter_mm", thousandths(measures.breast_diameter_mm) },
        { "slenderness", thousandths(measures.slenderness) },
        { "strahler", measures.strahler },
        { "bifurcation_ratio", thousandths(measures.bifurcation_ratio) },
        { "length_ratio", thousandths(measures.length_ratio) },
        { "pipe_exponent", thousandths(measures.pipe_exponent) },
    };
    return report.dump() + "\n";
}

} // namespace tractus::batch
