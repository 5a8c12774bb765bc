#include "app/batch/session_plant.h"

#include "app/terminal/error_text.h"
#include "engine/scene/edit_ids.h"
#include "engine/variation/growth.h"

#include <algorithm>
#include <fmt/core.h>
#include <span>

namespace tractus::batch {

namespace {

// Returns the name of the plant that was loaded last by the edits.
std::string plant_name(std::vector<scene::Edit> const& edits)
{
    std::string name;
    for (auto const& edit : edits) {
        if (auto const* const model = edit.get<scene::LoadModel>())
            name = model->source.name;
        else if (auto const* const skeleton = edit.get<scene::LoadSkeleton>())
            name = skeleton->name;
        else if (auto const* const measured = edit.get<scene::LoadMeasured>())
            name = measured->name;
    }
    return std::filesystem::path(name).stem().string();
}

} // namespace

bool is_session_file(std::filesystem::path const& path)
{
    return path.extension() == ".tractus";
}

// Returns the state after a step. A step is applied completely or not at all. The initial edits
// (step 0) are applied as far as possible, as there is no state before them.
static Result<scene::DocumentState> state_after(scene::DocumentState state,
                                                std::span<session::SessionEdit const> step,
                                                scene::SceneBuilder& builder)
{
    if (step.front().step == 0)
        return session::begin_document(step, builder);
    for (auto const& edit : step)
        state = TRY(scene::apply_edit(std::move(state), edit.edit, builder));
    return state;
}

Result<FoldedSession> fold_session(session::SessionContents const& contents,
                                   document::ModelCost const& cost)
{
    FoldedSession folded;
    scene::SceneBuilder builder(document::make_load_options(cost));
    scene::DocumentState state;
    std::span const all(contents.edits);
    for (auto const& edit : all)
        folded.unknown.add(edit);
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        session::UnknownEdits unknown;
        for (; end < all.size() && all[end].step == all[first].step; ++end)
            unknown.add(all[end]);
        if (all[first].step > contents.step)
            break;
        if (cost.is_stopped && cost.is_stopped())
            return fail(Fault::User, "it takes too long to draw: it was stopped");
        auto const step = all.subspan(first, end - first);
        auto after = state_after(state, step, builder);
        if (!after && first == 0)
            return tl::unexpected(after.error());
        if (!after) {
            folded.skipped_steps += unknown.count == 0;
            state.last_edit += step.size();
            continue;
        }
        state = *std::move(after);
        for (auto const& edit : step)
            if (!edit.edit.get<scene::UnknownEdit>())
                folded.edits.push_back(
                    scene::with_id(edit.edit, static_cast<std::uint64_t>(edit.place.number)));
    }
    folded.scene = TRY(session::build_scene(builder, std::move(state)));
    return folded;
}

static Result<FoldedSession> load_folded(std::filesystem::path const& path, scene::EditKinds kinds,
                                         document::ModelCost const& cost)
{
    auto const contents = TRY(session::read_session(path, kinds));
    auto folded = fold_session(contents, cost);
    if (!folded)
        return fail(folded.error().fault,
                    fmt::format("{}: {}", path.string(), folded.error().message));
    if (auto const said = folded->unknown.sentence(); !said.empty())
        terminal::print_warning(fmt::format("{}: {}", path.string(), said));
    if (folded->skipped_steps > 0)
        terminal::print_warning(fmt::format("{}: {} steps need what was lost and change nothing",
                                            path.string(), folded->skipped_steps));
    return folded;
}

Result<std::vector<scene::Edit>> session_edits(std::filesystem::path const& path,
                                               scene::EditKinds kinds)
{
    return TRY(load_folded(path, kinds, {})).edits;
}

Result<scene::Scene> load_session_scene(std::filesystem::path const& path, scene::EditKinds kinds,
                                        document::ModelCost const& cost)
{
    return TRY(load_folded(path, kinds, cost)).scene;
}

Result<Plant> shown_plant(scene::BuiltPlant const& built)
{
    auto const plan = TRY(scene::plan_growth(built));
    variation::Grower grower(plan);
    auto const& plant = grower.grow({ built.growth.seed, 0 }, built.growth.age);
    return built.growth.age < 1 ? variation::without_unborn(plant) : plant;
}

Result<session::Session> begin_session(std::filesystem::path const& path,
                                       std::vector<scene::Edit> const& edits,
                                       scene::EditKinds kinds)
{
    auto options = session::session_by_the_clock(kinds, [] { return document::load_options(); });
    session::SessionOrigin const origin { .plant = plant_name(edits),
                                          .program = TRACTUS_VERSION,
                                          .created = options.now() };
    return session::Session::create(path, origin, edits, options);
}

} // namespace tractus::batch
