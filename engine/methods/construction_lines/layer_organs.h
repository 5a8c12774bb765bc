#pragma once

#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// What stands at the nodes of a layer, where it differs from what stands on the rest of the plant.
struct LayerOrgans {
    std::optional<Pattern> pattern {}; // No value: the plant's. Its sizes do not count.
    std::size_t organ = 0; // Its number among the organs of the plant, from 1; 0: leaves.

    bool operator==(LayerOrgans const&) const = default;
};

// Whether organs of the pattern, or of a layer, stand elsewhere than on the stem's left and right.
bool stands_all_around(Pattern const& pattern, std::span<LayerOrgans const> layers);

// What the layers of a model bear, as tables that its rules read: pattern, roll and organ. Nothing
// is in them where all layers bear what the plant bears.
class LayerTables {
public:
    explicit LayerTables(Pattern const& of_plant)
        : patterns_ { of_plant }
    {
    }

    void add(LayerOrgans const& layer); // The next entry of each table.

    // The numbers that the table `pattern` has; the first is the plant's.
    std::vector<Pattern> const& patterns() const { return patterns_; }

    // Empty where all layers have the same.
    std::vector<double> pattern_numbers() const;
    std::vector<double> rolls_deg() const;

    std::vector<double> const& organs() const { return organs_; }

private:
    std::vector<Pattern> patterns_;
    std::vector<double> numbers_ {};
    std::vector<double> rolls_deg_ {};
    std::vector<double> organs_ {};
};

} // namespace tractus::lines
