#include "engine/scene/scene.h"

#include "engine/lsystem/derive.h"
#include "engine/lsystem/interpret.h"
#include "engine/plant/join_axes.h"
#include "engine/variation/place_nodes.h"

#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

Result<Scene> applied(Scene const& scene, LoadModel const& edit, LoadOptions const& options)
{
    auto const include = [&](std::string const& name) -> Result<std::string> {
        auto const found = edit.includes.find(name);
        if (found == edit.includes.end())
            return fail(Fault::User,
                        fmt::format("{} includes {}, which is missing", edit.source.name, name));
        return found->second;
    };
    auto const model = TRY(compile_model(edit.source, include));
    auto const string = TRY(derive(model,
                                   { .steps = edit.steps,
                                     .seed = edit.seed,
                                     .limits = options.limits,
                                     .print = options.print }));
    auto turtle = TRY(interpret_with_warnings(model, string, { .time = options.limits.time }));
    auto plant = join_axes(turtle.plant);

    Scene loaded;
    loaded.model_name = edit.source.name;
    loaded.model_warnings = model.warnings;
    loaded.model_warnings.insert(loaded.model_warnings.end(), turtle.warnings.begin(),
                                 turtle.warnings.end());
    loaded.placement = place_on_desk(plant);
    loaded.base = std::make_shared<Plant const>(std::move(plant));
    loaded.rest = std::make_shared<RestShape const>(find_rest_shape(*loaded.base));
    loaded.growth = scene.growth;
    loaded.growth_seed = scene.growth_seed;
    return loaded;
}

Result<Scene> applied(Scene scene, Select const& edit, LoadOptions const&)
{
    for (auto const& path : edit.paths)
        for (auto const segment : path)
            if (segment >= scene.base->segment_count())
                return fail(Fault::User,
                            fmt::format("segment {} cannot be selected: the plant has {}", segment,
                                        scene.base->segment_count()));
    scene.selection = edit.paths;
    return scene;
}

Result<Scene> applied(Scene scene, Associate const& edit, LoadOptions const&)
{
    if (scene.selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    for (auto const& path : scene.selection) {
        scene.associations.push_back(
            { .path = path, .stroke = edit.stroke, .propagation = edit.propagation });
        // Refused here, at its own edit, rather than later when the plant is grown.
        TRY(check_association(*scene.base, scene.associations.back()));
    }
    return scene;
}

Result<Scene> applied(Scene scene, Indicate const& edit, LoadOptions const&)
{
    TRY(check_indicator(*scene.base, edit.indicator));
    scene.indicators.push_back(edit.indicator);
    return scene;
}

Result<Scene> applied(Scene scene, SetGrowth const& edit, LoadOptions const&)
{
    TRY(check_growth_parameters(edit.parameters));
    scene.growth = edit.parameters;
    scene.growth_seed = edit.seed;
    return scene;
}

} // namespace

Result<Scene> apply_edit(Scene const& scene, Edit const& edit, LoadOptions const& options)
{
    return std::visit([&](auto const& kind) { return applied(scene, kind, options); }, edit);
}

Result<Scene> fold(std::span<Edit const> edits)
{
    Scene scene;
    for (auto const& edit : edits)
        scene = TRY(apply_edit(scene, edit));
    return scene;
}

Result<GrowthPlan> plan_growth(Scene const& scene)
{
    auto const shape = TRY(resolve_associations(*scene.base, *scene.rest, scene.associations));
    std::vector<Vec3> nodes_mm;
    place_nodes(*scene.base, *scene.rest, shape, nodes_mm);
    auto influence = TRY(influence_of(*scene.base, nodes_mm, scene.indicators,
                                      { scene.placement.shown_height_mm, scene.placement.scale }));
    return plan_growth(*scene.base, *scene.rest, shape, scene.growth, std::move(influence));
}

} // namespace tractus
