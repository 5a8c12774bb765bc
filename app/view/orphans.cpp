#include "app/view/orphans.h"

#include "engine/plant/plant_addresses.h"

#include <fmt/core.h>

namespace tractus::view {

// Describes a place on a plant, counting from 1: "segment 6 of branch 2 at segment 4 of stem 1". A
// branch that its source names becomes "40 % of a branch that is gone"; a place in a grafted part
// ends in "... of the plant 12 that was put on".
static std::string place_in_words(SegmentAddress const& address)
{
    if (auto const part = part_of(address); part != 0)
        return fmt::format("{} of the plant {} that was put on",
                           place_in_words(without_part(part_prefix(part), address)),
                           scene::name_of(part));
    std::string words;
    std::size_t begin = 0;
    if (address.size() >= 4 && address[0] == kKeyedAxis) {
        words = fmt::format("{:.0f} % of a branch that is gone", address[3] / 0x1p31 * 100);
        begin = 4;
    }
    for (std::size_t i = begin; i + 1 < address.size(); i += 2) {
        auto const axis = fmt::format("{} {}", i == 0 ? "stem" : "branch", address[i] + 1);
        words = fmt::format("segment {} of {}{}{}", address[i + 1] + 1, axis,
                            words.empty() ? "" : " at ", words);
    }
    return words;
}

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
