#pragma once

#include "app/controllers/file_queue.h"
#include "app/document/document.h"
#include "app/station/station.h"
#include "app/view/station_view.h"
#include "app/view/window_model.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::controllers {

// Applies a user's strokes and commands to a drawing: passes finished strokes to the document,
// shows the results, and supports undo. It makes no difference whether the station's reports come
// from live devices or from a log.
class StationController {
public:
    // Strokes are drawn on the session's scene, or on `scene` if there is no session. `folder` is
    // the folder for saved pictures and exports.
    StationController(station::Station const& station, std::optional<session::Session> session,
                      scene::Scene scene, std::filesystem::path folder);

    view::StationView& view() { return view_; }
    view::StationView const& view() const { return view_; }
    document::Document& document() { return *document_; }
    document::Document const& document() const { return *document_; }

    // Passes the station's finished strokes to the document, and shows the results of earlier
    // strokes and of background work.
    void show(station::Station& station, Timestamp now);

    // Like show(), but first waits until pending work is done or cannot continue for now.
    void settle(station::Station& station, Timestamp now);

    // Waits until all strokes and steps are saved. Fails with a user error if one cannot be saved.
    Result<void> finish(station::Station& station, Timestamp now);

    // True if the user may leave the drawing, given the result of finish(). After an error, returns
    // false once and shows the reason in the status; a second attempt to leave is allowed.
    bool may_close(Result<void> const& finished);

    // Waits until all requested files are written. Fails with the error that occurred first.
    Result<void> finish_files();

    // Returns the steps without a stroke that were done since the last call, for recording.
    std::vector<document::StepOutcome> take_done() { return std::exchange(done_, {}); }

    // Returns the tool to select after undo or redo has changed the options with which the plant
    // was drawn, if the selected tool had those options (ToolKind::like_drawn); otherwise nullopt.
    std::optional<tools::Tool> take_hand() { return std::exchange(hand_, std::nullopt); }

    // Returns an unused file name in the folder.
    std::filesystem::path new_file(std::string_view ending) const;

    void perform(view::NextVariation const&, station::Station& station);
    void perform(view::ChangeGrowth const& command, station::Station& station);
    void perform(view::ChangeSeason const& command, station::Station& station);
    void perform(view::RequestCollection const& command, station::Station& station);
    void perform(view::PickVariation const& command, station::Station& station);
    void perform(view::SetAlongGround const& command, station::Station& station);
    void perform(view::SavePicture const& command, station::Station& station);
    void perform(view::ExportPlant const& command, station::Station& station);
    void perform(view::NameDrawing const& command, station::Station& station);
    void perform(view::SaveCopy const& command, station::Station& station);
    void perform(view::WriteRules const&, station::Station& station);
    void perform(view::Undo const&, station::Station& station);
    void perform(view::Redo const&, station::Station& station);
    void perform(view::TakeOrphansAway const&, station::Station& station);
    void perform(view::PickCurve const& command, station::Station& station);
    void perform(view::LayPictureFile const& command, station::Station& station);
    void perform(view::DragDrawnGizmo const& command, station::Station& station);
    void perform(view::SetActiveFoliage const& command, station::Station& station);
    void perform(view::BringLeaf const& command, station::Station& station);

    // After the numbers of a tool have changed, adapts what was drawn with it (ToolKind::follow).
    // preview_following() only shows the result; let_follow() makes it an undoable step. Both do
    // nothing if no drawing is affected.
    void preview_following(tools::Tool const& before, tools::Tool const& after);
    void let_follow(tools::Tool const& before, tools::Tool const& after, station::Station& station);

    // Updates the active plant after its model's file was saved; what was drawn on the plant is
    // kept. If the model is invalid, the plant does not change and `status` gives the reason.
    void take_model(Result<scene::LoadModel> model, station::Station& station);

    // Returns the rules file if one was written since the last call.
    std::optional<std::filesystem::path> take_rules_file();

    // Returns the document to its beginning and shows `status`. If the drawing is saved in a file,
    // the status says instead that the session is as it began.
    void begin_again(station::Station& station, std::string const& status,
                     document::Document::Growth growth = document::Document::Growth::AsItBegan);

    // Shows the drawing with another station, and this status.
    void show_again(station::Station const& station, std::string const& status);

private:
    void show_name();
    void save(std::string_view ending,
              std::function<Result<std::string>(std::filesystem::path const&)> write);
    void take_strokes(station::Station& station);
    void announce_dab(station::Station const& station);
    void show_document(station::Station& station, Timestamp now);
    void show_files();
    void set_growth(
        std::function<Result<document::StepRequest::Change>(scene::SetGrowth growth)> const& change,
        station::Station& station);

    // On the heap, because this controller is movable.
    std::unique_ptr<document::Document> document_;
    view::StationView view_;
    std::vector<document::StepOutcome> done_; // Steps that take_done() has not returned yet.
    std::optional<tools::Tool> hand_;         // Tool that take_hand() has not returned yet.
    // Number of the station's dabs (touches too short for a stroke) that have been handled.
    std::size_t reported_dabs_ = 0;
    // Kinds of tools for which the message about dabs has been shown.
    std::set<tools::ToolKind const*> tools_with_reported_dabs_ {};
    Timestamp now_ {}; // Time of the last show().
    // True once the user has been warned that unsaved work would be lost.
    bool has_warned_of_loss_ = false;
    std::filesystem::path folder_;
    std::optional<std::filesystem::path> rules_file_ {};
    // On the heap, because this controller is movable.
    std::unique_ptr<FileQueue> files_ = std::make_unique<FileQueue>();
};

} // namespace tractus::controllers
