#pragma once

#include "app/methods/self_organising/growth_brush_tool.h"
#include "app/tools/tool.h"
#include "engine/base/result.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <vector>

namespace tractus::methods {

// Lets a self-organising tree fill the crown of the active plant, if this plant was drawn by its
// outline. The drawn trunk and branches remain; buds on them compete for the space inside the
// crown.
struct FillCrownTool {
    static tools::ToolKind const kKind;

    enum class When { Touch, AtOnce } when = When::Touch;
    self_organising::GrowthBrushTool::Species species
        = self_organising::GrowthBrushTool::Species::Oak;
    self_organising::GrowthBrushTool::Edition edition
        = self_organising::GrowthBrushTool::Edition::Full;
};

// The edit that fills the crown of a scene's active plant by up to `years` years of growth. Fails
// with a user error if the plant was not drawn by its outline, or has no crown.
Result<scene::Edit> fill_crown(scene::Scene const& scene, self_organising::Habit const& habit,
                               int years, std::uint64_t seed);

} // namespace tractus::methods
