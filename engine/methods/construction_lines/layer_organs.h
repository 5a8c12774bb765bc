#pragma once

#include "engine/methods/construction_lines/pattern.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// The organs at the nodes of a layer, where they differ from those of the rest of the plant.
struct LayerOrgans {
    // Pattern of the layer; its `sizes` are ignored. No value: the pattern of the plant.
    std::optional<Pattern> pattern {};
    // Number of the layer's organ among the plant's organs, from 1; 0: plain leaves.
    std::size_t organ = 0;

    bool operator==(LayerOrgans const&) const = default;
};

// True if the plant's pattern, or that of a layer, has organs elsewhere than on the stem's left and
// right.
bool has_organs_all_around(Pattern const& pattern, std::span<LayerOrgans const> layers);

// The pattern, roll and organ of each of a model's layers, as tables that the model's rules read.
class LayerTables {
public:
    explicit LayerTables(Pattern const& of_plant)
        : patterns_ { of_plant }
    {
    }

    void add(LayerOrgans const& layer); // Appends an entry to each table.

    // Patterns to which pattern_numbers() refers by index; the first is that of the plant.
    std::vector<Pattern> const& patterns() const { return patterns_; }

    // Entries of each table, one per layer. pattern_numbers() and rolls_deg() are empty if all
    // layers have the plant's pattern or roll.
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
