#include "app/plants/session_plant.h"

#include "engine/variation/growth.h"

#include <fmt/core.h>

namespace tractus {

namespace {

// The name of the plant that edits load last.
std::string plant_name(std::vector<Edit> const& edits)
{
    std::string name;
    for (auto const& edit : edits) {
        if (auto const* const model = std::get_if<LoadModel>(&edit))
            name = model->source.name;
        else if (auto const* const skeleton = std::get_if<LoadSkeleton>(&edit))
            name = skeleton->name;
    }
    return std::filesystem::path(name).stem().string();
}

} // namespace

bool is_session_file(std::filesystem::path const& path)
{
    return path.extension() == ".tractus";
}

Result<std::vector<Edit>> session_edits(std::filesystem::path const& path)
{
    auto contents = TRY(read_session(path));
    std::vector<Edit> edits;
    for (auto& kept : contents.edits)
        if (kept.step <= contents.step)
            edits.push_back(std::move(kept.edit));
    return edits;
}

Result<Scene> load_session_scene(std::filesystem::path const& path, ModelCost const& cost)
{
    Scene scene;
    for (auto const& edit : TRY(session_edits(path))) {
        auto next = apply_edit(std::move(scene), edit, load_options(cost));
        if (!next)
            return fail(next.error().fault,
                        fmt::format("{}: {}", path.string(), next.error().message));
        scene = *std::move(next);
    }
    return scene;
}

Result<Plant> shown_plant(Scene const& scene)
{
    auto const plan = TRY(plan_growth(scene));
    Grower grower(plan);
    auto const& plant = grower.grow({ scene.growth.seed, 0 }, scene.growth.age);
    return scene.growth.age < 1 ? without_unborn(plant) : plant;
}

Result<Session> begin_session(std::filesystem::path const& path, std::vector<Edit> const& edits)
{
    auto options = session_by_the_clock([] { return load_options(); });
    SessionOrigin const origin { plant_name(edits), TRACTUS_VERSION, options.now() };
    return Session::create(path, origin, edits, std::move(options));
}

} // namespace tractus
