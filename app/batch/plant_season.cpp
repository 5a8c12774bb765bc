#include "app/batch/plant_season.h"

#include "app/methods/all_following.h"
#include "app/methods/all_leaves.h"

#include <fmt/core.h>
#include <set>
#include <string>
#include <utility>

namespace tractus::batch {

Result<std::vector<scene::Edit>> season_edits(scene::Scene const& scene,
                                              std::optional<scene::Season> const& season)
{
    std::vector<scene::Edit> edits;
    std::set<std::string> missing;
    if (season)
        for (auto const& plant : scene.plants)
            missing.merge(
                scene::missing_leaves(*plant->foliated, *season, scene.state.leaf_sheets));
    for (auto const& name : missing) {
        auto sheet = methods::sheet_for(scene, name);
        if (!sheet)
            return fail(
                sheet.error().fault,
                fmt::format("the plants cannot change with the season: {}", sheet.error().message));
        edits.emplace_back(scene::KeepLeaves { name, *std::move(sheet) });
    }
    edits.emplace_back(season ? scene::SetSeason { season->month, season->fallen }
                              : scene::SetSeason {});
    return edits;
}

std::vector<scene::Edit> following_edits(scene::Scene const& scene,
                                         std::vector<scene::Edit> const& step)
{
    auto following = methods::dependent_edits(scene, step);
    if (!following.has_leaves || !scene.state.season)
        return following.edits;
    auto all = step;
    all.insert(all.end(), following.edits.begin(), following.edits.end());
    auto const after = scene::apply_edits(scene, all);
    if (!after || !after->state.season)
        return following.edits;
    // If leaves cannot be grown for the season, existing leaves only change their colour.
    if (auto const grown = season_edits(*after, after->state.season))
        for (auto const& edit : *grown)
            if (edit.get<scene::KeepLeaves>())
                following.edits.push_back(edit);
    return following.edits;
}

Result<scene::Scene> with_season(scene::Scene scene, std::optional<scene::Season> const& season)
{
    if (!season)
        return scene;
    auto const edits = TRY(season_edits(scene, season));
    return scene::apply_edits(std::move(scene), edits);
}

} // namespace tractus::batch
