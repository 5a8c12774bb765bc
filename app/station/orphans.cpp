#include "app/station/orphans.h"

#include <fmt/core.h>

namespace tractus {

// "segment 6 of branch 2 at segment 4 of stem 1", all counted from 1.
static std::string place_in_words(SegmentAddress const& address)
{
    std::string words;
    for (std::size_t i = 0; i + 1 < address.size(); i += 2) {
        auto const axis = fmt::format("{} {}", i == 0 ? "stem" : "branch", address[i] + 1);
        words = fmt::format("segment {} of {}{}{}", address[i + 1] + 1, axis,
                            words.empty() ? "" : " at ", words);
    }
    return words;
}

std::vector<OrphanView> orphans_of(Scene const& scene)
{
    std::vector<OrphanView> orphans;
    for (std::size_t i = 0; i < scene.associations.size(); ++i)
        if (scene.associations[i].is_orphaned)
            orphans.push_back({ OrphanView::Kind::Stroke, i, fmt::format("stroke {}", i + 1),
                                "up to " + place_in_words(scene.places[i]->last) });
    for (std::size_t i = 0; i < scene.indicators.size(); ++i)
        if (scene.indicators[i].is_orphaned)
            orphans.push_back({ OrphanView::Kind::Indicator, i,
                                fmt::format("motion indicator {}", i + 1),
                                place_in_words(scene.indicator_places[i].front()) });
    return orphans;
}

std::vector<Edit> edits_without_orphans(Scene const& scene)
{
    std::vector<Edit> edits;
    DeleteStroke strokes;
    for (auto const& orphan : orphans_of(scene))
        if (orphan.kind == OrphanView::Kind::Stroke)
            strokes.associations.push_back(orphan.number);
        else // The last first: the others keep their numbers.
            edits.insert(edits.begin(), DeleteIndicator { orphan.number });
    if (!strokes.associations.empty())
        edits.push_back(std::move(strokes));
    return edits;
}

} // namespace tractus
