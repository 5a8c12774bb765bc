#include "engine/lsystem/derive.h"
#include "engine/lsystem/interpret.h"
#include "engine/plant/join_axes.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <map>
#include <utility>

namespace tractus {

namespace {

// In the order of the enumerations' values.
constexpr std::array kDrawn { "forget", "keep" };

// Finds the branches that something was drawn for again, by where they were.
void keep_drawn(Scene before, Scene& now)
{
    // By their places, which those for the same branch share. Empty: there is none.
    std::map<PathAddress const*, SharedVector<SegmentId>> paths;
    for (auto drawn : before.associations) {
        auto const [found, is_new] = paths.try_emplace(drawn.at.data());
        if (is_new)
            if (auto path = now.rest->addresses.find_path(*now.base, drawn.at.front()))
                found->second = *std::move(path);
        drawn.what.path = found->second;
        drawn.what.is_orphaned = drawn.what.path.empty();
        now.associations.push_back(std::move(drawn));
    }
    now.indicators = std::move(before.indicators);
    for (auto& [id, indicator, at] : now.indicators) {
        indicator.below.clear();
        for (auto const& place : at)
            if (auto const segment = now.rest->addresses.find_segment(*now.base, place.last))
                indicator.below.push_back(*segment);
        indicator.is_orphaned = indicator.below.empty() && !at.empty();
    }
}

// The scene with another base plant.
Scene with_plant(Scene scene, std::string const& name, Plant plant, Drawn drawn)
{
    Scene loaded;
    loaded.model_name = name;
    loaded.placement = place_on_desk(plant);
    loaded.base = std::make_shared<Plant const>(std::move(plant));
    loaded.rest = std::make_shared<RestShape const>(find_rest_shape(*loaded.base));
    loaded.growth = std::move(scene.growth);
    loaded.last_edit = scene.last_edit;
    if (drawn == Drawn::Keep)
        keep_drawn(std::move(scene), loaded);
    return loaded;
}

std::string file_name(std::string const& path)
{
    return std::filesystem::path(path).filename().string();
}

char const* describe_drawn(Drawn drawn)
{
    return drawn == Drawn::Keep ? ", and keeps what was drawn" : "";
}

void list(Fields& fields, LoadModel& edit)
{
    fields.field("name", &edit.source.name);
    fields.field("text", &edit.source.text);
    fields.field("view_name", &edit.source.view_name);
    fields.field("view_text", &edit.source.view_text);
    fields.field("includes", &edit.includes);
    fields.field("steps", &edit.steps);
    fields.field("seed", &edit.seed);
    fields.word("drawn", edit.drawn, kDrawn);
}

Result<Scene> applied(Scene scene, LoadModel const& edit, LoadOptions const& options)
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
    auto turtle = TRY(interpret_with_warnings(model, string,
                                              { .max_modules = options.limits.max_modules,
                                                .max_memory_bytes = options.limits.max_memory_bytes,
                                                .time = options.limits.time,
                                                .print = options.print }));
    auto loaded
        = with_plant(std::move(scene), edit.source.name, join_axes(turtle.plant), edit.drawn);
    loaded.model_warnings = model.warnings;
    loaded.model_warnings.insert(loaded.model_warnings.end(), turtle.warnings.begin(),
                                 turtle.warnings.end());
    return loaded;
}

std::string described(LoadModel const& edit)
{
    auto text = fmt::format("takes the model {}: {} of rules", file_name(edit.source.name),
                            counted(edit.source.text.size(), "byte"));
    if (!edit.includes.empty())
        text += fmt::format(", {}", counted(edit.includes.size(), "more file"));
    if (edit.steps)
        text += fmt::format(
            ", {}", counted(static_cast<std::size_t>(std::max(*edit.steps, 0)), "derivation step"));
    return fmt::format("{}, seed {}{}", text, edit.seed, describe_drawn(edit.drawn));
}

void list(Fields& fields, LoadSkeleton& edit)
{
    fields.field("name", &edit.name);
    fields.word("drawn", edit.drawn, kDrawn);
    fields.numbers(edit.lines);
}

Result<Scene> applied(Scene scene, LoadSkeleton const& edit, LoadOptions const&)
{
    auto plant = TRY(plant_from_lines(edit.name, edit.lines));
    return with_plant(std::move(scene), edit.name, std::move(plant), edit.drawn);
}

std::string described(LoadSkeleton const& edit)
{
    return fmt::format("takes the skeleton {}: {}{}", file_name(edit.name),
                       counted(edit.lines.size(), "line"), describe_drawn(edit.drawn));
}

} // namespace

constexpr EditKind LoadModel::kKind
    = make_edit_kind<LoadModel, list, applied, described>("load_model", true);

constexpr EditKind LoadSkeleton::kKind
    = make_edit_kind<LoadSkeleton, list, applied, described>("load_skeleton", true);

} // namespace tractus
