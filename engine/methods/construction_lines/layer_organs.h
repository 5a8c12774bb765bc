#pragma once

#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// The organs at the nodes of a layer, where they differ from those of the rest of the plant.
struct LayerOrgans {
    // Pattern of the layer, without its `sizes`; no value: the plant's.
    std::optional<Pattern> pattern {};
    // Number of the layer's organ among the organs of the plant, from 1; 0: leaves.
    std::size_t organ = 0;

    bool operator==(LayerOrgans const&) const = default;
};

// True if organs of the pattern, or of a layer, occur elsewhere than on the stem's left and right.
bool has_organs_all_around(Pattern const& pattern, std::span<LayerOrgans const> layers);

// The organs of a model's layers as tables that its rules read: pattern, roll and organ. Empty if
// all layers have the plant's organs.
class LayerTables {
public:
    explicit LayerTables(Pattern const& of_plant)
        : patterns_ { of_plant }
    {
    }

    void add(LayerOrgans const& layer); // Appends an entry to each table.

    // Patterns to which pattern_numbers() refer; the first is the plant's.
    std::vector<Pattern> const& patterns() const { return patterns_; }

    // Entries of the tables; each table is empty if all layers have the same value.
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
