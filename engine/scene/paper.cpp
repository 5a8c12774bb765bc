#include "engine/scene/paper.h"

#include "engine/scene/desk_placement.h"

#include <utility>

namespace tractus {

Paper paper_of(DocumentState const& state)
{
    constexpr double kGround = 0.1; // Of the tablet's depth, above its lower edge.
    Paper paper { .base_mm = { 0, (kGround - 0.5) * DrawingVolume {}.depth_mm } };
    auto const* const plant = active_plant(state);
    if (!plant)
        return paper;
    paper.stands_mm = plant->stands_at_mm;
    if (plant->paper_mm)
        paper.base_mm = *plant->paper_mm;
    else
        paper.base_mm.x() = plant->stands_at_mm.x();
    return paper;
}

void redraw_on_paper(DocumentState& state, std::size_t number, PlantSource source,
                     Vec2 const& base_mm)
{
    change_plant(state, number, [&](PlantState& plant) {
        plant.source = std::move(source);
        plant.source_edit = state.last_edit;
        plant.selection.clear();
        if (plant.paper_mm)
            plant.stands_at_mm.x() += base_mm.x() - plant.paper_mm->x();
        plant.paper_mm = base_mm;
    });
}

} // namespace tractus
