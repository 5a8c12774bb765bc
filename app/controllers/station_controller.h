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

// Applies what a person does to a drawing, wherever its station's reports come from: finished
// strokes go to the document, and what is drawn and done is shown and can be undone.
class StationController {
public:
    // Strokes work on the session's scene if there is one, else on `scene`. `folder` is where saved
    // pictures and exports appear.
    StationController(station::Station const& station, std::optional<session::Session> session,
                      scene::Scene scene, std::filesystem::path folder);

    view::StationView& view() { return view_; }
    view::StationView const& view() const { return view_; }
    document::Document& document() { return *document_; }
    document::Document const& document() const { return *document_; }

    // Hands the station's finished strokes to the document, shows what has become of earlier ones,
    // and what has been done in the background meanwhile.
    void show(station::Station& station, Timestamp now);

    // Does as show() when all that is under way is done, or cannot be done for now.
    void settle(station::Station& station, Timestamp now);

    // Waits until what was drawn, and what was done beside drawing, is kept. Fails, as the user's
    // fault, if something cannot be.
    Result<void> finish(station::Station& station, Timestamp now);

    // Whether a person who wants to leave may do so, given what finish() says: else the status
    // tells why not, and the next time they may all the same.
    bool may_close(Result<void> const& finished);

    // Waits until the files that a person has asked for are written. Fails with the first that
    // could not be.
    Result<void> finish_files();

    // The steps beside drawing that were done since the last call, for a recording.
    std::vector<document::DoneStep> take_done() { return std::exchange(done_, {}); }

    // What the hand holds since undo or redo, where it held what the plant was drawn with before
    // (ToolKind::like_drawn). No value: the same as before, or it was given out already.
    std::optional<tools::Tool> take_hand() { return std::exchange(hand_, std::nullopt); }

    // A new file's name in the folder.
    std::filesystem::path new_file(std::string_view ending) const;

    void perform(view::NextVariation const&, station::Station& station);
    void perform(view::ChangeGrowth const& command, station::Station& station);
    void perform(view::ChangeSeason const& command, station::Station& station);
    void perform(view::AskForCollection const& command, station::Station& station);
    void perform(view::PickVariation const& command, station::Station& station);
    void perform(view::SavePicture const& command, station::Station& station);
    void perform(view::ExportPlant const& command, station::Station& station);
    void perform(view::NameDrawing const& command, station::Station& station);
    void perform(view::SaveCopy const& command, station::Station& station);
    void perform(view::WriteRules const&, station::Station& station);
    void perform(view::Undo const&, station::Station& station);
    void perform(view::Redo const&, station::Station& station);
    void perform(view::TakeOrphansAway const&, station::Station& station);
    void perform(view::LayPictureFile const& command, station::Station& station);
    void perform(view::DragDrawnGlyph const& command, station::Station& station);
    void perform(view::DressActivePlant const& command, station::Station& station);
    void perform(view::BringLeaf const& command, station::Station& station);

    // What has been drawn with a tool follows other numbers (ToolKind::follow): is only shown so,
    // or does as a step, if anything does.
    void preview_following(tools::Tool const& before, tools::Tool const& after);
    void let_follow(tools::Tool const& before, tools::Tool const& after, station::Station& station);

    // The model of the active plant has been saved: the plant is that of its new text, with what
    // was drawn on it. Where it is none any more, the plant stays and `status` says why.
    void take_model(Result<scene::LoadModel> model, station::Station& station);

    // The file of rules that was written since the last call, if one was.
    std::optional<std::filesystem::path> take_rules_file();

    // The document is as it began; where it is in no file `status` says so.
    void begin_again(station::Station& station, std::string const& status,
                     document::Document::Growth growth = document::Document::Growth::AsItBegan);

    // Shows another station, and what led to it.
    void show_again(station::Station const& station, std::string const& status);

private:
    void show_name();
    void save(std::string_view ending,
              std::function<Result<std::string>(std::filesystem::path const&)> write);
    void take_strokes(station::Station& station);
    void tell_of_dab(station::Station const& station);
    void show_document(station::Station& station, Timestamp now);
    void show_files();
    void set_growth(
        std::function<Result<document::WantedStep::Change>(scene::SetGrowth growth)> const& change,
        station::Station& station);

    std::unique_ptr<document::Document> document_; // On the heap, as this moves.
    view::StationView view_;
    std::vector<document::DoneStep> done_; // Steps that are not taken yet.
    std::optional<tools::Tool> hand_;      // Likewise.
    std::size_t told_dabs_ = 0;            // Of the station's, those that have been looked at.
    std::set<tools::ToolKind const*> told_dabs_of_ {}; // Kinds of which a dab has been told.
    Timestamp now_ {};                                 // Time of the last show().
    bool knows_what_is_lost_ = false;                  // A person who has asked to leave.
    std::filesystem::path folder_;
    std::optional<std::filesystem::path> rules_file_ {};
    // On the heap, as this moves.
    std::unique_ptr<FileQueue> files_ = std::make_unique<FileQueue>();
};

} // namespace tractus::controllers
