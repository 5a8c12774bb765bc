#include "app/controllers/live_rig.h"
#include "app/controllers/live_window.h"

#include <utility>

// This file contains the tour, and the exchange of devices that it needs.
namespace tractus::controllers {

// Returns the simulated rig whose hand draws the tour's tree.
Result<LiveWindow::DevicesInUse> LiveWindow::devices_of_tour() const
{
    DevicesInUse hand {
        .devices = TRY(devices::LiveDevices::play_hand(options_.now, "demo/tour.tractus-log")),
        .station_options = station_options_,
        .is_hand_simulated = true,
    };
    hand.station_options.is_height_watched = true;
    hand.station_options.scripted_height.reset();
    hand.station_options.rig = TRY(choose_rig(hand.devices, {}, {}));
    return hand;
}

// Draws with other devices from now on. Reports that these sent before are ignored. Fails like
// Station::create(); the devices in use then stay.
Result<void> LiveWindow::exchange_devices(DevicesInUse& other)
{
    auto station = TRY(station::Station::create(other.devices.infos(), other.station_options));
    // An error in saving is ignored here: saving unsaved steps is tried again later.
    static_cast<void>(finish());
    std::swap(devices_, other.devices);
    std::swap(station_options_, other.station_options);
    auto& state = view().state();
    std::swap(state.mouse_draws, other.mouse_draws);
    std::swap(state.is_hand_simulated, other.is_hand_simulated);
    std::swap(state.mouse_moves_surface, other.mouse_moves_surface);
    std::swap(state.may_calibrate, other.may_calibrate);
    devices_.take(reports_);
    lost_reports_ = devices_.lost_count();
    states_.clear();
    for (std::size_t i = 0; i < devices_.infos().size(); ++i)
        states_.push_back(devices_.state(i));
    diagnosis_.reset();
    go_on_with(std::move(station));
    controller_->show_again(station_, {});
    return {};
}

void LiveWindow::give_devices_back()
{
    if (!user_devices_)
        return;
    if (auto const exchanged = exchange_devices(*user_devices_); !exchanged)
        view().state().status = exchanged.error().message;
    user_devices_.reset();
}

void LiveWindow::perform_kind(view::BeginTour const&)
{
    perform_kind(view::EndTour {});
    if (recorder_) // A recording is of the user's devices.
        perform_kind(view::SetRecording { false });
    calibration_.reset();
    auto hand = devices_of_tour();
    if (auto const exchanged = hand ? exchange_devices(*hand) : tl::unexpected(hand.error());
        !exchanged) {
        view().state().status = exchanged.error().message;
        return;
    }
    user_devices_ = *std::move(hand);
    tour_.emplace();
    shown_tour_step_ = 0;
    show_tour();
}

void LiveWindow::perform_kind(view::SkipTourStep const&)
{
    if (!tour_)
        return;
    tour_->skip();
    show_tour();
}

void LiveWindow::perform_kind(view::EndTour const&)
{
    if (!tour_)
        return;
    tour_.reset();
    give_devices_back();
    view().state().tour.reset();
    ++view().state().live_revision;
}

void LiveWindow::follow_tour()
{
    if (!tour_)
        return;
    if (user_devices_ && devices_.is_hand_over()) {
        give_devices_back();
        // The hand's last stroke must be in the drawing before the user's strokes are counted.
        controller_->settle(station_, options_.now());
    }
    tour_->look({ .is_hand_over = !user_devices_,
                  .strokes = state().curves.size(),
                  .indicators = scene().indicators.size() });
    show_tour();
}

// Shows the tour's step. When a step begins, gives the user the devices and the tool for it.
void LiveWindow::show_tour()
{
    if (!tour_->waits_for_hand())
        give_devices_back();
    if (std::exchange(shown_tour_step_, tour_->step()) != tour_->step())
        if (auto const* const kind = tools::find_tool_kind(options_.methods.tools, tour_->tool()))
            perform_kind(view::ChooseTool { tools::Tool(*kind) });
    auto& state = view().state();
    auto shown = tour_->view(
        { .mouse_draws = state.mouse_draws, .mouse_moves_surface = state.mouse_moves_surface });
    if (state.tour == shown)
        return;
    state.tour = std::move(shown);
    ++state.live_revision;
}

} // namespace tractus::controllers
