#include "app/replay_window.h"

#include <algorithm>
#include <utility>

namespace tractus {

Result<ReplayWindow> ReplayWindow::create(Log const& log, ReplayOptions options,
                                          std::filesystem::path pictures)
{
    auto replay = TRY(LogReplay::create(log, options));
    return ReplayWindow(log, std::move(options), std::move(pictures), std::move(replay));
}

ReplayWindow::ReplayWindow(Log const& log, ReplayOptions options, std::filesystem::path pictures,
                           LogReplay replay)
    : log_(&log)
    , options_(std::move(options))
    , replay_(std::move(replay))
    , now_(replay_.begin())
    , view_(replay_.station(), std::move(pictures))
{
    view_.state().status = "The hand begins";
}

void ReplayWindow::advance(Duration real_step)
{
    auto& state = view_.state();
    if (!state.playing)
        return;
    now_ += from_seconds(to_seconds(real_step) * state.speed);
    bool const goes_on = replay_.advance_to(now_);
    view_.show(replay_.station());
    if (!goes_on) {
        state.playing = false;
        state.status = "The recording has ended: play it again, or take another seed";
    }
    double const length_s = to_seconds(replay_.end() - replay_.begin());
    state.progress
        = length_s > 0 ? std::clamp(to_seconds(now_ - replay_.begin()) / length_s, 0.0, 1.0) : 1;
}

void ReplayWindow::perform(WindowCommand const& command)
{
    std::visit([this](auto const& kind) { perform_kind(kind); }, command);
}

void ReplayWindow::perform_kind(SetPlaying const& command)
{
    if (command.playing && now_ >= replay_.end())
        perform_kind(Restart {});
    view_.state().playing = command.playing;
}

void ReplayWindow::perform_kind(SetSpeed const& command)
{
    view_.state().speed = std::clamp(command.speed, 0.25, 4.0);
}

void ReplayWindow::perform_kind(Restart const&)
{
    auto& state = view_.state();
    auto again = LogReplay::create(*log_, options_);
    if (!again) {
        state.status = again.error().message;
        return;
    }
    replay_ = *std::move(again);
    now_ = replay_.begin();
    state.playing = true;
    state.progress = 0;
    state.status = "The hand begins again";
    view_.begin_again(replay_.station());
}

void ReplayWindow::perform_kind(NextVariation const&)
{
    view_.show_next_variation(replay_.station());
}

void ReplayWindow::perform_kind(SavePicture const& command)
{
    view_.save(command.picture, replay_.station());
}

} // namespace tractus
