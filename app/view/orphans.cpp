#include "app/view/orphans.h"

#include "app/view/branch_words.h"

namespace tractus::view {

std::vector<OrphanView> orphans_of(scene::Scene const& scene)
{
    std::vector<OrphanView> orphans;
    for (auto const& [id, association, at] : scene.associations)
        if (association.is_orphaned)
            orphans.push_back({ OrphanView::Kind::Stroke, id, "stroke " + scene::name_of(id),
                                "up to " + place_in_words(at.front().last) });
    for (auto const& [id, indicator, at] : scene.indicators)
        if (indicator.is_orphaned)
            orphans.push_back({ OrphanView::Kind::Indicator, id,
                                "motion indicator " + scene::name_of(id),
                                place_in_words(at.front().last) });
    return orphans;
}

std::vector<scene::Edit> edits_without_orphans(scene::Scene const& scene)
{
    std::vector<scene::Edit> edits;
    scene::DeleteStroke strokes;
    for (auto const& orphan : orphans_of(scene))
        if (orphan.kind == OrphanView::Kind::Stroke)
            strokes.strokes.ids.push_back(orphan.id);
        else
            edits.push_back(scene::DeleteIndicator { orphan.id });
    if (!strokes.strokes.empty())
        edits.push_back(std::move(strokes));
    return edits;
}

} // namespace tractus::view
