#pragma once

#include "app/session_keeper.h"
#include "app/station.h"
#include "app/station_view.h"
#include "app/window/window_model.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus {

// What a person does to a drawing beside drawing, wherever its station's reports come from: what is
// drawn and done is kept, shown, and can be undone.
class StationDesk {
public:
    // `pictures` is the folder in which saved pictures appear.
    StationDesk(Station const& station, std::optional<Session> session,
                std::filesystem::path pictures);

    StationView& view() { return view_; }
    StationView const& view() const { return view_; }
    SessionKeeper& keeper() { return keeper_; }
    SessionKeeper const& keeper() const { return keeper_; }

    // Keeps what has been drawn before it is seen to be done, shows it, and lets the station forget
    // its strokes.
    void show(Station& station, Timestamp now);

    void perform(NextVariation const&, Station& station);
    void perform(ChangeGrowth const& command, Station& station);
    void perform(AskForCollection const& command, Station& station);
    void perform(PickVariation const& command, Station& station);
    void perform(SavePicture const& command, Station& station);
    void perform(Undo const&, Station& station);
    void perform(Redo const&, Station& station);

    // Shows another scene of the station, and what led to it; or why nothing did.
    void show_again(Result<void> const& done, Station const& station, std::string const& status);

private:
    void set_growth(SetGrowth const& growth, Station& station, std::string const& status);

    SessionKeeper keeper_;
    StationView view_;
};

} // namespace tractus
