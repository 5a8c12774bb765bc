#include "app/plants/plant_season.h"

#include "app/methods/all_leaves.h"

#include <fmt/core.h>
#include <set>
#include <string>
#include <utility>

namespace tractus {

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

Result<Scene> with_season(Scene scene, std::optional<Season> const& season)
{
    if (!season)
        return scene;
    auto const edits = TRY(season_edits(scene, season));
    return apply_edits(std::move(scene), edits);
}

} // namespace tractus
