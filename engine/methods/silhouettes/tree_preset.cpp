#include "engine/methods/silhouettes/tree_preset.h"

#include <array>

namespace tractus::silhouette {

// The table has a namespace of its own for the short names of patterns.
namespace presets {

using enum Pattern::Kind;

constexpr std::array<TreePreset, 11> kForms { {
    { "oak",
      { .patterns = { Even, Even, Even },
        .leaves = 36,
        .leaf_width = 0.55,
        .plane_branches = 26,
        .base_angle_deg = 88,
        .tip_angle_deg = 40,
        .rise = 0.3,
        .bark = BarkKind::Oak } },
    { "pine",
      { .patterns = { Whorls, TwoRows, TwoRows },
        .density = 1.5,
        .leaves = 120,
        .leaf_width = 0.05,
        .plane_branches = 28,
        .base_angle_deg = 88,
        .tip_angle_deg = 50,
        .rise = 0.3,
        .bark = BarkKind::Pine } },
    { "willow",
      { .patterns = { Even, Even, Even },
        .density = 1.5,
        .leaves = 150,
        .leaf_width = 0.1,
        .plane_branches = 28,
        .base_angle_deg = 60,
        .tip_angle_deg = 30,
        .rise = -0.8,
        .bark = BarkKind::Willow } },
    { "eucalyptus",
      { .patterns = { Spiral, Horizontal, Horizontal },
        .density = 0.75,
        .leaves = 16,
        .leaf_width = 0.2,
        .plane_branches = 22,
        .base_angle_deg = 55,
        .tip_angle_deg = 30,
        .rise = 0.4,
        .bark = BarkKind::Plane } },
    { "fir",
      { .levels = 1,
        .patterns = { Spiral, TwoRows, TwoRows },
        .density = 1.5,
        .leaves = 120,
        .leaf_width = 0.25,
        .plane_branches = 36,
        .base_angle_deg = 98,
        .tip_angle_deg = 50,
        .rise = 0.15,
        .bark = BarkKind::Fir } },
    { "poplar",
      { .patterns = { Spiral, Spiral, Spiral },
        .leaves = 30,
        .leaf_width = 0.9,
        .plane_branches = 30,
        .base_angle_deg = 35,
        .tip_angle_deg = 20,
        .rise = 0.35,
        .bark = BarkKind::Poplar } },
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
    { "umbrella_pine",
      { .patterns = { Spiral, Even, Even },
        .leaves = 120,
        .leaf_width = 0.05,
        .plane_branches = 20,
        .base_angle_deg = 100,
        .tip_angle_deg = 76,
        .rise = 0.2,
        .bark = BarkKind::Pine } },
    { "baobab",
      { .patterns = { Even, Even, Even },
        .density = 0.7,
        .leaves = 16,
        .leaf_width = 0.4,
        .plane_branches = 14,
        .base_angle_deg = 75,
        .tip_angle_deg = 45,
        .rise = 0.5,
        .bark = BarkKind::Beech } },
    { "acacia",
      { .patterns = { Spiral, Horizontal, Horizontal },
        .leaves = 80,
        .leaf_width = 0.3,
        .plane_branches = 18,
        .base_angle_deg = 100,
        .tip_angle_deg = 72,
        .rise = -0.2,
        .bark = BarkKind::Alder } },
    { "birch",
      { .patterns = { Spiral, Even, Even },
        .density = 1.2,
        .leaves = 32,
        .leaf_width = 0.65,
        .plane_branches = 30,
        .base_angle_deg = 50,
        .tip_angle_deg = 25,
        .rise = -0.6,
        .bark = BarkKind::Birch } },
} };

// Index of the fern in kForms.
constexpr std::size_t kFern = 6;

} // namespace presets

std::span<TreePreset const> tree_presets()
{
    return presets::kForms;
}

bool fills_outline(TreeForm const& form)
{
    return form.styles != presets::kForms[presets::kFern].form.styles;
}

} // namespace tractus::silhouette
