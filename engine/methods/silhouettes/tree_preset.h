#pragma once

#include "engine/methods/silhouettes/outlined_tree.h"

#include <span>
#include <string_view>

namespace tractus::silhouette {

// A preset: the branching pattern of a kind of tree and its twigs. Works with any outline.
struct TreePreset {
    std::string_view name; // Stable identifier, used in logs and on the command line.
    TreeForm form {};
};

// The presets: oak, pine, willow, eucalyptus, fir, poplar, fern, umbrella_pine, baobab, acacia and
// birch.
std::span<TreePreset const> tree_presets();

// Whether the leaves of new trees with this form fill their outline
// (TreeForm::leaves_reach_outline): all but ferns, whose pinnae are seen apart.
bool fills_outline(TreeForm const& form);

} // namespace tractus::silhouette
