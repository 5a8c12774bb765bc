#include "engine/methods/silhouettes/tree_preset.h"

#include <array>

namespace tractus::silhouette {

std::span<TreePreset const> tree_presets()
{
    using enum Pattern::Kind;
    static constexpr std::array<TreePreset, 7> kForms { {
        { "oak",
          { .patterns = { Even, Even, Even },
            .leaves = 36,
            .leaf_width = 0.55,
            .plane_branches = 26 } },
        { "pine",
          { .patterns = { Whorls, TwoRows, TwoRows },
            .density = 1.5,
            .leaves = 120,
            .leaf_width = 0.05,
            .plane_branches = 28 } },
        { "willow",
          { .patterns = { Even, Even, Even },
            .density = 1.5,
            .leaves = 150,
            .leaf_width = 0.1,
            .plane_branches = 28 } },
        { "eucalyptus",
          { .patterns = { Spiral, Horizontal, Horizontal },
            .density = 0.75,
            .leaves = 16,
            .leaf_width = 0.2,
            .plane_branches = 22 } },
        { "fir",
          { .levels = 1,
            .patterns = { Spiral, TwoRows, TwoRows },
            .density = 1.5,
            .leaves = 120,
            .leaf_width = 0.25,
            .plane_branches = 36 } },
        { "poplar",
          { .patterns = { Spiral, Spiral, Spiral },
            .leaves = 30,
            .leaf_width = 0.9,
            .plane_branches = 30,
            .base_angle_deg = 35,
            .tip_angle_deg = 20 } },
        { "fern",
          { .levels = 1,
            .patterns = { TwoRows, TwoRows, TwoRows },
            .styles = { { { .children = 56,
                            .unbranched = 0.12,
                            .spacing = 0.015,
                            .first_angle_deg = 80,
                            .last_angle_deg = 40 } } },
            .leaves = 60,
            .leaf_width = 0.35,
            .plane_branches = 26 } },
    } };
    return kForms;
}

bool fills_outline(TreeForm const& form)
{
    auto const& fern = tree_presets().back();
    return form.styles != fern.form.styles;
}

} // namespace tractus::silhouette
