#pragma once

#include "app/live/file_queue.h"
#include "app/station/session_keeper.h"
#include "app/station/station.h"
#include "app/station/station_view.h"
#include "app/station/window_model.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace tractus {

// What a person does to a drawing beside drawing, wherever its station's reports come from: what is
// drawn and done is kept, shown, and can be undone.
class StationController {
public:
    // `folder` is where saved pictures and exports appear.
    StationController(Station const& station, std::optional<Session> session,
                      std::filesystem::path folder);

    StationView& view() { return view_; }
    StationView const& view() const { return view_; }
    SessionKeeper& keeper() { return keeper_; }
    SessionKeeper const& keeper() const { return keeper_; }

    // Keeps what has been drawn, shows it once it is kept, and until then as ink; lets the station
    // forget its strokes; and shows what has been done in the background meanwhile.
    void show(Station& station, Timestamp now);

    // The same when all that is under way is done, or cannot be done for now.
    void settle(Station& station, Timestamp now);

    // Waits until what was drawn, and what was done beside drawing, is kept. Fails, as the user's
    // fault, if something cannot be.
    Result<void> finish(Station& station, Timestamp now);

    // Whether a person who wants to leave may do so, given what finish() says: else the status
    // tells why not, and the next time they may all the same.
    bool may_close(Result<void> const& finished);

    // Waits until the files that a person has asked for are written. Fails with the first that
    // could not be.
    Result<void> finish_files();

    // A new file's name in the folder.
    std::filesystem::path new_file(std::string_view ending) const;

    void perform(NextVariation const&, Station& station);
    void perform(ChangeGrowth const& command, Station& station);
    void perform(AskForCollection const& command, Station& station);
    void perform(PickVariation const& command, Station& station);
    void perform(SavePicture const& command, Station& station);
    void perform(ExportPlant const& command, Station& station);
    void perform(Undo const&, Station& station);
    void perform(Redo const&, Station& station);
    void perform(TakeOrphansAway const&, Station& station);
    void perform(Restart const&, Station& station); // There must be a session.

    // Shows another scene of the station, and what led to it.
    void show_again(Station const& station, std::string const& status);

private:
    void save(std::string_view ending,
              std::function<Result<std::string>(std::filesystem::path const&)> write);
    void show_kept(Station& station, Timestamp now);
    void show_files();
    void set_growth(std::function<Result<WantedStep::Change>(SetGrowth growth)> const& change,
                    Station& station);

    SessionKeeper keeper_;
    StationView view_;
    Timestamp now_ {};                // Of the last show().
    bool knows_what_is_lost_ = false; // A person who has asked to leave.
    std::filesystem::path folder_;
    std::unique_ptr<FileQueue> files_ = std::make_unique<FileQueue>(); // As this moves.
};

} // namespace tractus
