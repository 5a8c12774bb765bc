#include "app/session/session_history.h"

#include "engine/base/check.h"
#include "engine/scene/make_edit_kind.h"

#include <fmt/core.h>
#include <iterator>
#include <utility>

namespace tractus {

// Which scenes are kept: those of so many steps around the last that counts, and of every so many
// farther away, up to a distance. Few, since each has a list of all strokes, though their tips are
// shared; and making a step again costs next to nothing.
static constexpr std::size_t kNear = 2;
static constexpr std::size_t kEvery = 64;
static constexpr std::size_t kFar = 192;

static std::size_t distance(std::size_t one, std::size_t other)
{
    return one < other ? other - one : one - other;
}

static void list(Fields&, BeginAgain&) { }

// NOLINTNEXTLINE(performance-unnecessary-value-param): as for all kinds.
static Result<Scene> applied(Scene, BeginAgain const&, LoadOptions const&)
{
    return fail(Fault::Station, "only its history knows how a drawing began");
}

static std::string described(BeginAgain const&)
{
    return "begins again";
}

constexpr EditKind BeginAgain::kKind = make_edit_kind<BeginAgain, list, applied, described>("");

// What is in the file leaves memory.
static void park_tips(Scene& scene)
{
    for (std::size_t i = 0; i < scene.associations.size(); ++i) {
        auto const& tips = scene.associations[i].what.stroke.tips;
        if (!tips.source() || !tips.is_in_memory())
            continue;
        auto association = scene.associations[i];
        association.what.stroke.tips = tips.parked();
        scene.associations.replace(i, std::move(association));
    }
}

Result<SessionHistory> SessionHistory::create(SessionExtent const& extent, ReadStep const& read,
                                              MakeLoadOptions load_options)
{
    SessionHistory history(extent, std::move(load_options));
    history.scene_ = TRY(history.fold({}, 0, history.step(), read));
    return history;
}

SessionHistory::SessionHistory(SessionExtent const& extent, MakeLoadOptions load_options)
    : extent_(extent)
    , load_options_(std::move(load_options))
{
}

SessionHistory::SessionHistory(Scene beginning, MakeLoadOptions load_options)
    : load_options_(std::move(load_options))
    , scene_(std::move(beginning))
{
    keep(0, scene_);
}

Result<Scene> SessionHistory::apply(Scene scene, Edit const& edit) const
{
    if (edit.get<BeginAgain>()) {
        auto beginning = kept_.at(0);
        beginning.last_edit += scene.last_edit; // No edit has the number of an earlier one.
        return beginning;
    }
    return apply_edit(std::move(scene), edit, load_options_());
}

Result<Scene> SessionHistory::after(std::span<Edit const> edits) const
{
    auto scene = scene_;
    for (auto const& edit : edits)
        scene = TRY(apply(std::move(scene), edit));
    return scene;
}

Result<Scene> SessionHistory::at(std::size_t wanted, ReadStep const& read)
{
    CHECK(wanted <= last_step());
    // From the nearest scene before it that is known; that of the beginning always is.
    auto const& [kept_step, kept_scene] = *std::prev(kept_.upper_bound(wanted));
    if (step() <= wanted && step() >= kept_step)
        return fold(scene_, step() + 1, wanted, read);
    return fold(kept_scene, kept_step + 1, wanted, read);
}

Result<Scene> SessionHistory::fold(Scene scene, std::size_t first, std::size_t last,
                                   ReadStep const& read)
{
    for (auto next = first; next <= last; ++next) {
        auto const edits = TRY(read(next));
        scene = next == 0 ? TRY(begin(edits)) : apply_step(std::move(scene), edits);
        // Not after each, since it looks at all strokes.
        if (is_worth_keeping(next) || next % kEvery == 0 || next == last)
            park_tips(scene);
        if (is_worth_keeping(next))
            keep(next, scene);
    }
    return scene;
}

Result<Scene> SessionHistory::begin(std::span<SessionEdit const> edits) const
{
    Scene scene;
    for (auto const& [step, edit, made, place] : edits) {
        auto applied = apply(scene, edit);
        if (applied)
            scene = *std::move(applied);
        else if (edit.kind().loads_plant)
            return fail(applied.error().fault,
                        fmt::format("edit {}: {}", place.number, applied.error().message));
        else
            ++scene.last_edit;
    }
    return scene;
}

// A step that needs something which was lost, or that is unknown, changes nothing and stays in the
// file. Its edits are counted, for a program that knows them does so, too.
Scene SessionHistory::apply_step(Scene scene, std::span<SessionEdit const> edits) const
{
    auto next = scene;
    for (auto const& edit : edits) {
        auto applied = apply(std::move(next), edit.edit);
        if (!applied) {
            scene.last_edit += edits.size();
            return scene;
        }
        next = *std::move(applied);
    }
    return next;
}

void SessionHistory::push(Scene scene)
{
    park_tips(scene);
    auto const before = extent_.step++;
    extent_.last_step = extent_.step;
    keep(before, std::exchange(scene_, std::move(scene)));
    kept_.erase(kept_.lower_bound(extent_.step), kept_.end());
}

void SessionHistory::go_to(std::size_t step, Scene scene)
{
    auto const left = std::exchange(extent_.step, step);
    keep(left, std::exchange(scene_, std::move(scene)));
}

void SessionHistory::keep(std::size_t step, Scene scene)
{
    kept_.insert_or_assign(step, std::move(scene));
    std::erase_if(kept_, [&](auto const& entry) { return !is_worth_keeping(entry.first); });
}

// The beginning always is: its plant takes longest.
bool SessionHistory::is_worth_keeping(std::size_t step) const
{
    auto const away = distance(step, extent_.step);
    return step == 0 || away <= kNear || (step % kEvery == 0 && away <= kFar);
}

} // namespace tractus
