#include "app/session/session_history.h"

#include "engine/base/check.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <fmt/core.h>
#include <iterator>
#include <utility>

namespace tractus::session {

// Which states are cached: those of the kNear steps before and after the current step, and that of
// every kEvery-th step up to kFar steps away. Not all states are cached, since each has a list of
// all strokes (the strokes themselves are shared). There are enough that undo repeats only a few
// steps, some of which take 0.1 s on large plants.
static constexpr std::size_t kNear = 16;
static constexpr std::size_t kEvery = 16;
static constexpr std::size_t kFar = 192;

static std::size_t distance(std::size_t one, std::size_t other)
{
    return one < other ? other - one : one - other;
}

static void list(scene::Fields&, BeginAgain&) { }

// NOLINTNEXTLINE(performance-unnecessary-value-param): as for all kinds.
static Result<scene::DocumentState> applied(scene::DocumentState, BeginAgain const&,
                                            scene::SceneBuilder&)
{
    return fail(Fault::Station, "only its history knows how a drawing began");
}

static std::string described(BeginAgain const&)
{
    return "begins again";
}

constexpr scene::EditKind BeginAgain::kKind
    = scene::make_edit_kind<BeginAgain, list, applied, described>("");

// Frees the tips of those strokes that can be read again from the file.
static void park_tips(scene::DocumentState& state)
{
    auto const is_in_both = [](auto const& tips) { return tips.source() && tips.is_in_memory(); };
    for (std::size_t number = 0; number < state.plants.size(); ++number) {
        auto const& strokes = state.plants[number]->strokes;
        if (std::none_of(strokes.begin(), strokes.end(),
                         [&](auto const& stroke) { return is_in_both(stroke.what.stroke.tips); }))
            continue;
        scene::change_plant(state, number, [&](scene::PlantState& plant) {
            for (std::size_t i = 0; i < plant.strokes.size(); ++i) {
                if (!is_in_both(plant.strokes[i].what.stroke.tips))
                    continue;
                auto stroke = plant.strokes[i];
                stroke.what.stroke.tips = stroke.what.stroke.tips.parked();
                plant.strokes.replace(i, std::move(stroke));
            }
        });
    }
}

Result<SessionHistory> SessionHistory::create(SessionExtent const& extent, ReadStep const& read,
                                              scene::SceneBuilder& builder)
{
    SessionHistory history(extent);
    history.state_ = TRY(history.fold({}, 0, history.step(), read, builder));
    return history;
}

SessionHistory::SessionHistory(SessionExtent const& extent)
    : extent_(extent)
{
}

SessionHistory::SessionHistory(scene::DocumentState beginning)
    : state_(std::move(beginning))
{
    keep(0, state_);
}

Result<scene::DocumentState> SessionHistory::apply(scene::DocumentState state,
                                                   scene::Edit const& edit,
                                                   scene::SceneBuilder& builder) const
{
    if (edit.get<BeginAgain>()) {
        auto beginning = kept_.at(0);
        beginning.last_edit += state.last_edit; // So that no two edits have the same number.
        return beginning;
    }
    return scene::apply_edit(std::move(state), edit, builder);
}

Result<scene::DocumentState> SessionHistory::after(std::span<scene::Edit const> edits,
                                                   scene::SceneBuilder& builder) const
{
    auto state = state_;
    for (auto const& edit : edits)
        state = TRY(apply(std::move(state), edit, builder));
    return state;
}

Result<scene::DocumentState> SessionHistory::at(std::size_t wanted, ReadStep const& read,
                                                scene::SceneBuilder& builder)
{
    CHECK(wanted <= last_step());
    // Starts from the nearest earlier state that is cached. Step 0 is always cached.
    auto const& [kept_step, kept_state] = *std::prev(kept_.upper_bound(wanted));
    if (step() <= wanted && step() >= kept_step)
        return fold(state_, step() + 1, wanted, read, builder);
    return fold(kept_state, kept_step + 1, wanted, read, builder);
}

Result<scene::DocumentState> SessionHistory::fold(scene::DocumentState state, std::size_t first,
                                                  std::size_t last, ReadStep const& read,
                                                  scene::SceneBuilder& builder)
{
    for (auto next = first; next <= last; ++next) {
        auto const edits = TRY(read(next));
        state = next == 0 ? TRY(begin_document(edits, builder))
                          : apply_step(std::move(state), edits, builder);
        // Tips are freed only after some of the steps, because doing so visits all strokes.
        if (is_worth_keeping(next) || next % kEvery == 0 || next == last)
            park_tips(state);
        if (is_worth_keeping(next))
            keep(next, state);
    }
    return state;
}

Result<scene::DocumentState> begin_document(std::span<SessionEdit const> edits,
                                            scene::SceneBuilder& builder)
{
    scene::DocumentState state;
    for (auto const& [step, edit, made, place] : edits) {
        auto applied = scene::apply_edit(state, edit, builder);
        if (applied)
            state = *std::move(applied);
        else if (edit.kind().loads_plant)
            return fail(applied.error().fault,
                        fmt::format("edit {}: {}", place.number, applied.error().message));
        else
            // A failed edit is counted as well, because a program that knows the edit counts it.
            ++state.last_edit;
    }
    return state;
}

Result<scene::Scene> build_scene(scene::SceneBuilder& builder, scene::DocumentState state)
{
    auto scene = builder.build(std::move(state));
    if (!scene)
        return fail(scene.error().fault,
                    fmt::format("edit {}: {}", builder.failed_edit(), scene.error().message));
    return scene;
}

// Applies a step. If something that the step needs is lost or unknown, the step has no effect and
// stays in the file. Its edits are counted nevertheless, because a program that knows them counts
// them.
scene::DocumentState SessionHistory::apply_step(scene::DocumentState state,
                                                std::span<SessionEdit const> edits,
                                                scene::SceneBuilder& builder) const
{
    auto next = state;
    for (auto const& edit : edits) {
        auto applied = apply(std::move(next), edit.edit, builder);
        if (!applied) {
            state.last_edit += edits.size();
            return state;
        }
        next = *std::move(applied);
    }
    return next;
}

void SessionHistory::push(scene::DocumentState state)
{
    park_tips(state);
    auto const before = extent_.step++;
    extent_.last_step = extent_.step;
    keep(before, std::exchange(state_, std::move(state)));
    kept_.erase(kept_.lower_bound(extent_.step), kept_.end());
}

void SessionHistory::go_to(std::size_t step, scene::DocumentState state)
{
    auto const left = std::exchange(extent_.step, step);
    keep(left, std::exchange(state_, std::move(state)));
}

void SessionHistory::keep(std::size_t step, scene::DocumentState state)
{
    kept_.insert_or_assign(step, std::move(state));
    std::erase_if(kept_, [&](auto const& entry) { return !is_worth_keeping(entry.first); });
}

// True if the state after a step is to be cached. The state after step 0 is always cached: a
// drawing without a file needs it to begin again.
bool SessionHistory::is_worth_keeping(std::size_t step) const
{
    auto const away = distance(step, extent_.step);
    return step == 0 || away <= kNear || (step % kEvery == 0 && away <= kFar);
}

} // namespace tractus::session
