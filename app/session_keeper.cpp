#include "app/session_keeper.h"

#include "app/model_cost.h"

#include <fmt/core.h>
#include <utility>
#include <vector>

namespace tractus {

void SessionKeeper::keep_strokes(Station const& station, Timestamp now)
{
    constexpr Duration kPatience = std::chrono::seconds(1);
    if (!session_ || (!not_kept_.empty() && now < next_try_))
        return;
    not_kept_.clear();
    for (auto const& strokes = station.strokes(); kept_strokes_ < strokes.size(); ++kept_strokes_) {
        auto const kept = session_->append(strokes[kept_strokes_].edits);
        if (!kept) {
            not_kept_ = kept.error().message;
            next_try_ = now + kPatience;
            return;
        }
    }
}

void SessionKeeper::forget_kept(Station& station)
{
    if (!not_kept_.empty())
        return;
    station.forget_strokes();
    kept_strokes_ = 0;
}

Result<void> SessionKeeper::check_kept() const
{
    if (not_kept_.empty())
        return {};
    return fail(Fault::User, fmt::format("what was drawn must be kept first: {}", not_kept_));
}

Result<void> SessionKeeper::make(std::span<Edit const> edits, Station& station)
{
    TRY(check_kept());
    if (session_) {
        TRY(session_->append(edits));
        station.set_scene(session_->scene());
        return {};
    }
    auto scene = station.scene();
    for (auto const& edit : edits)
        scene = TRY(apply_edit(std::move(scene), edit, load_options()));
    station.set_scene(std::move(scene));
    return {};
}

Result<void> SessionKeeper::undo(Station& station)
{
    if (!session_)
        return fail(Fault::User, "nothing can be undone: there is no session");
    TRY(check_kept());
    TRY(session_->undo());
    station.set_scene(session_->scene());
    return {};
}

Result<void> SessionKeeper::redo(Station& station)
{
    if (!session_)
        return fail(Fault::User, "nothing can be done again: there is no session");
    TRY(check_kept());
    TRY(session_->redo());
    station.set_scene(session_->scene());
    return {};
}

Result<void> SessionKeeper::begin_again(Station& station)
{
    std::vector<Edit> beginning;
    for (auto const& [step, edit, made] : session_->contents().edits)
        if (step == 0)
            beginning.push_back(edit);
    return make(beginning, station);
}

} // namespace tractus
