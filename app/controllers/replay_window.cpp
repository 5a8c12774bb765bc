#include "app/controllers/replay_window.h"

#include <algorithm>
#include <utility>

namespace tractus::controllers {

Result<ReplayWindow> ReplayWindow::create(drivers::Log const& log, station::ReplayOptions options,
                                          scene::Scene scene, std::filesystem::path pictures,
                                          std::optional<session::Session> session)
{
    auto replay = TRY(station::LogReplay::create(log, options));
    StationController controller(replay.station(), std::move(session), std::move(scene),
                                 std::move(pictures));
    return ReplayWindow(log, std::move(options), std::move(replay), std::move(controller));
}

ReplayWindow::ReplayWindow(drivers::Log const& log, station::ReplayOptions options,
                           station::LogReplay replay, StationController controller)
    : log_(&log)
    , options_(std::move(options))
    , replay_(std::move(replay))
    , now_(replay_.begin())
    , controller_(std::move(controller))
{
    // A status that is already set warns of unknown edits in the session.
    if (view().state().status.empty())
        view().state().status
            = replay_.left_out().empty() ? "The hand begins" : replay_.left_out().front();
}

ReplayWindow::~ReplayWindow()
{
    static_cast<void>(close());
}

// Ends the replay. An unfinished stroke is dropped.
Result<void> ReplayWindow::finish()
{
    return controller_.finish(replay_.station(), now_);
}

Result<void> ReplayWindow::close()
{
    auto const kept = finish();
    auto const written = controller_.finish_files();
    return kept ? written : kept;
}

void ReplayWindow::advance(Duration real_step)
{
    auto& state = view().state();
    view().pass(real_step);
    if (!state.playing) {
        controller_.show(replay_.station(), now_);
        return;
    }
    now_ += from_seconds(to_seconds(real_step) * state.speed);
    bool const goes_on = replay_.advance_to(now_);
    replay_.replay_into(controller_.document());
    controller_.show(replay_.station(), now_);
    if (!goes_on) {
        auto const kept = replay_.outcome() ? finish() : replay_.outcome();
        controller_.show(replay_.station(), now_);
        state.playing = false;
        state.status = kept ? "The recording has ended: play it again, or take another seed"
                            : kept.error().message;
    }
    double const length_s = to_seconds(replay_.end() - replay_.begin());
    state.progress
        = length_s > 0 ? std::clamp(to_seconds(now_ - replay_.begin()) / length_s, 0.0, 1.0) : 1;
}

void ReplayWindow::perform(view::WindowCommand const& command)
{
    std::visit([this](auto const& kind) { perform_kind(kind); }, command);
}

void ReplayWindow::perform_kind(view::SetPlaying const& command)
{
    if (command.playing && now_ >= replay_.end())
        perform_kind(view::Restart {});
    view().state().playing = command.playing;
}

void ReplayWindow::perform_kind(view::SetSpeed const& command)
{
    view().state().speed = std::clamp(command.speed, 0.25, 4.0);
}

void ReplayWindow::perform_kind(view::Restart const&)
{
    auto& state = view().state();
    if (auto const kept = finish(); !kept) {
        state.status = kept.error().message;
        return;
    }
    auto again = station::LogReplay::create(*log_, options_);
    if (!again) {
        state.status = again.error().message;
        return;
    }
    replay_ = *std::move(again);
    now_ = replay_.begin();
    state.playing = true;
    state.progress = 0;
    view().begin_again(replay_.station(), controller_.document());
    // Growth stays as the user has set it. A session returns to its beginning.
    controller_.begin_again(replay_.station(), "The hand begins again",
                            document::Document::Growth::AsItIs);
}

} // namespace tractus::controllers
