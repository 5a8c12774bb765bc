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

// Applies a user's strokes and commands to a drawing, wherever the station's reports come from:
// passes finished strokes to the document, shows the results, and supports undo.
class StationController {
public:
    // Strokes are applied to the session's scene, or to `scene` if there is no session. `folder` is
    // where saved pictures and exports go.
    StationController(station::Station const& station, std::optional<session::Session> session,
                      scene::Scene scene, std::filesystem::path folder);

    view::StationView& view() { return view_; }
    view::StationView const& view() const { return view_; }
    document::Document& document() { return *document_; }
    document::Document const& document() const { return *document_; }

    // Passes the station's finished strokes to the document, and shows the results of earlier
    // strokes and of background work.
    void show(station::Station& station, Timestamp now);

    // Like show(), but first waits until all pending work is done or cannot be done for now.
    void settle(station::Station& station, Timestamp now);

    // Waits until all strokes and steps are saved. Fails with a user error if some cannot be.
    Result<void> finish(station::Station& station, Timestamp now);

    // True if the user may leave, given the result of finish(). On an error, returns false once and
    // shows the reason in the status; a second request is granted.
    bool may_close(Result<void> const& finished);

    // Waits until all requested files are written. Fails with the first error.
    Result<void> finish_files();

    // Steps without a stroke that were done since the last call, to be recorded.
    std::vector<document::StepOutcome> take_done() { return std::exchange(done_, {}); }

    // The tool to select after undo or redo, if the plant's tool had been selected
    // (ToolKind::like_drawn); nullopt: no change, or already taken.
    std::optional<tools::Tool> take_hand() { return std::exchange(hand_, std::nullopt); }

    // An unused file name in the folder.
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

    // Adapts what was drawn with a tool after the tool's numbers have changed (ToolKind::follow).
    // preview_following() only shows the result, let_follow() makes it an undoable step; neither
    // does anything if nothing follows.
    void preview_following(tools::Tool const& before, tools::Tool const& after);
    void let_follow(tools::Tool const& before, tools::Tool const& after, station::Station& station);

    // Updates the active plant after its model's file was saved, keeping what was drawn on it. If
    // the model is invalid, the plant stays and `status` gives the reason.
    void take_model(Result<scene::LoadModel> model, station::Station& station);

    // The rules file written since the last call, if any.
    std::optional<std::filesystem::path> take_rules_file();

    // Returns the document to its beginning; `status` mentions if the drawing is not saved in a
    // file.
    void begin_again(station::Station& station, std::string const& status,
                     document::Document::Growth growth = document::Document::Growth::AsItBegan);

    // Shows another station, with this status.
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

    std::unique_ptr<document::Document> document_; // On the heap, because this object is movable.
    view::StationView view_;
    std::vector<document::StepOutcome> done_; // Steps that take_done() has not returned yet.
    std::optional<tools::Tool> hand_;         // Tool that take_hand() has not returned yet.
    std::size_t reported_dabs_ = 0; // Number of the station's dabs (touches too short for a stroke)
                                    // handled so far.
    // Kinds of tools for which the message about dabs was shown.
    std::set<tools::ToolKind const*> tools_with_reported_dabs_ {};
    Timestamp now_ {};                // Time of the last show().
    bool has_warned_of_loss_ = false; // The user has already been warned once about losing unsaved
                                      // work.
    std::filesystem::path folder_;
    std::optional<std::filesystem::path> rules_file_ {};
    // On the heap, because this object is movable.
    std::unique_ptr<FileQueue> files_ = std::make_unique<FileQueue>();
};

} // namespace tractus::controllers
