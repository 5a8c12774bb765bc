#include "app/batch/plant_season.h"

#include "app/methods/all_leaves.h"

#include <fmt/core.h>
#include <set>
#include <string>
#include <utility>

namespace tractus::batch {

Result<std::vector<Edit>> season_edits(Scene const& scene, std::optional<Season> const& season)
{
    std::vector<Edit> edits;
    std::set<std::string> missing;
    if (season)
        for (auto const& plant : scene.plants)
            missing.merge(missing_leaves(*plant->dressed, *season, scene.state.leaf_sheets));
    for (auto const& name : missing) {
        auto sheet = sheet_for(scene, name);
        if (!sheet)
            return fail(
                sheet.error().fault,
                fmt::format("the plants cannot change with the season: {}", sheet.error().message));
        edits.emplace_back(KeepLeaves { name, *std::move(sheet) });
    }
    edits.emplace_back(season ? SetSeason { season->month, season->fallen } : SetSeason {});
    return edits;
}

std::vector<Edit> following_edits(Scene const& scene, std::vector<Edit> const& step)
{
    auto edits = edits_that_follow(scene, step);
    if (edits.empty() || !scene.state.season)
        return edits;
    auto all = step;
    all.insert(all.end(), edits.begin(), edits.end());
    auto const after = apply_edits(scene, all);
    if (!after || !after->state.season)
        return edits;
    // Leaves that cannot be grown for the season keep their colour alone.
    if (auto const grown = season_edits(*after, after->state.season))
        for (auto const& edit : *grown)
            if (edit.get<KeepLeaves>())
                edits.push_back(edit);
    return edits;
}

Result<Scene> with_season(Scene scene, std::optional<Season> const& season)
{
    if (!season)
        return scene;
    auto const edits = TRY(season_edits(scene, season));
    return apply_edits(std::move(scene), edits);
}

} // namespace tractus::batch
