#include "app/session/session_history.h"

#include "engine/base/check.h"

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

Result<SessionHistory> SessionHistory::create(SessionContents contents,
                                              MakeLoadOptions load_options)
{
    SessionHistory history(std::move(contents), std::move(load_options));
    history.scene_ = TRY(history.fold({}, 0, history.step()));
    return history;
}

SessionHistory::SessionHistory(SessionContents contents, MakeLoadOptions load_options)
    : contents_(std::move(contents))
    , load_options_(std::move(load_options))
{
    CHECK(!contents_.edits.empty());
    for (std::size_t i = 0; i < contents_.edits.size(); ++i)
        if (contents_.edits[i].step == first_edit_.size())
            first_edit_.push_back(i);
}

Result<Scene> SessionHistory::after(std::span<Edit const> edits) const
{
    auto scene = scene_;
    for (auto const& edit : edits)
        scene = TRY(apply_edit(std::move(scene), edit, load_options_()));
    return scene;
}

Result<Scene> SessionHistory::at(std::size_t wanted)
{
    CHECK(wanted <= contents_.last_step());
    // From the nearest scene before it that is known; that of the beginning always is.
    auto const& [kept_step, kept_scene] = *std::prev(kept_.upper_bound(wanted));
    if (step() <= wanted && step() >= kept_step)
        return fold(scene_, step() + 1, wanted);
    return fold(kept_scene, kept_step + 1, wanted);
}

Result<Scene> SessionHistory::fold(Scene scene, std::size_t first, std::size_t last)
{
    for (auto next = first; next <= last; ++next) {
        auto const end
            = next + 1 < first_edit_.size() ? first_edit_[next + 1] : contents_.edits.size();
        for (auto i = first_edit_[next]; i < end; ++i) {
            auto applied = apply_edit(std::move(scene), contents_.edits[i].edit, load_options_());
            if (!applied)
                return fail(applied.error().fault,
                            fmt::format("edit {}: {}", i + 1, applied.error().message));
            scene = *std::move(applied);
        }
        if (is_worth_keeping(next))
            keep(next, scene);
    }
    return scene;
}

void SessionHistory::push(SessionStep const& next, Scene scene)
{
    CHECK(next.number == step() + 1);
    keep(step(), std::exchange(scene_, std::move(scene)));
    kept_.erase(kept_.lower_bound(next.number), kept_.end());
    if (next.number < first_edit_.size()) {
        contents_.edits.resize(first_edit_[next.number]);
        first_edit_.resize(next.number);
    }
    first_edit_.push_back(contents_.edits.size());
    for (auto const& edit : next.edits)
        contents_.edits.push_back({ next.number, edit, next.made });
    contents_.step = next.number;
}

void SessionHistory::go_to(std::size_t step, Scene scene)
{
    auto const left = std::exchange(contents_.step, step);
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
    auto const away = distance(step, contents_.step);
    return step == 0 || away <= kNear || (step % kEvery == 0 && away <= kFar);
}

} // namespace tractus
