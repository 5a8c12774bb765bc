#include "engine/methods/construction_lines/layer_organs.h"

#include <algorithm>

namespace tractus::lines {

bool has_organs_all_around(Pattern const& pattern, std::span<LayerOrgans const> layers)
{
    auto const of_layer = [](LayerOrgans const& layer) {
        return layer.pattern && has_organs_all_around(*layer.pattern);
    };
    return has_organs_all_around(pattern) || std::any_of(layers.begin(), layers.end(), of_layer);
}

void LayerTables::add(LayerOrgans const& layer)
{
    auto const& pattern = layer.pattern ? *layer.pattern : patterns_.front();
    // Patterns that differ only in the roll of organs share their rules, because the roll has its
    // own table.
    auto const is_same = [&](Pattern const& other) {
        return other.kind == pattern.kind && other.divergence_deg == pattern.divergence_deg
            && other.whorl == pattern.whorl;
    };
    auto known = std::find_if(patterns_.begin(), patterns_.end(), is_same);
    if (known == patterns_.end())
        known = patterns_.insert(known, pattern);
    numbers_.push_back(static_cast<double>(known - patterns_.begin()));
    rolls_deg_.push_back(roll_deg(pattern));
    organs_.push_back(static_cast<double>(layer.organ));
}

std::vector<double> LayerTables::pattern_numbers() const
{
    return patterns_.size() > 1 ? numbers_ : std::vector<double>();
}

std::vector<double> LayerTables::rolls_deg() const
{
    double const of_plant_deg = roll_deg(patterns_.front());
    bool const is_one = std::all_of(rolls_deg_.begin(), rolls_deg_.end(),
                                    [&](double deg) { return deg == of_plant_deg; });
    return is_one ? std::vector<double>() : rolls_deg_;
}

} // namespace tractus::lines
