#include "engine/scene/paper.h"

#include "engine/scene/desk_placement.h"

#include <utility>

namespace tractus::scene {

Paper paper_of(DocumentState const& state)
{
    // Height of the plant's base above the sheet's lower edge, as a share of the tablet's depth.
    constexpr double kGround = 0.1;
    Paper paper { .base_mm = { 0, (kGround - 0.5) * DrawingVolume {}.depth_mm } };
    auto const* const plant = active_plant(state);
    if (!plant)
        return paper;
    if (auto const own = paper_of(*plant))
        return *own;
    paper.world_point_mm = plant->stands_at_mm;
    paper.base_mm.x() = plant->stands_at_mm.x();
    return paper;
}

std::optional<Paper> paper_of(PlantState const& plant)
{
    if (!plant.paper_mm)
        return std::nullopt;
    return Paper { *plant.paper_mm, plant.stands_at_mm, plant.paper_unit };
}

void redraw_on_paper(DocumentState& state, std::size_t number, PlantSource source,
                     Vec2 const& base_mm)
{
    change_plant(state, number, [&](PlantState& plant) {
        plant.source = std::move(source);
        plant.source_edit = state.last_edit;
        plant.selection.clear();
        if (plant.paper_mm)
            plant.stands_at_mm.x() += plant.paper_unit * (base_mm.x() - plant.paper_mm->x());
        plant.paper_mm = base_mm;
    });
}

} // namespace tractus::scene
