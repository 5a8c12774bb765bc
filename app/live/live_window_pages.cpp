#include "app/live/live_window.h"

#include "app/live/drawn_leaf_files.h"
#include "app/live/unnamed_session.h"
#include "app/methods/all_leaves.h"
#include "app/user_folder.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

// The pages that the window shows in place of the drawing, and what is chosen there.
namespace tractus {

StartPageModel* LiveWindow::start_page()
{
    if (choices_ && choices_->is_open())
        return choices_.get();
    return drawings_are_open() ? options_.start_page.get() : nullptr;
}

bool LiveWindow::drawings_are_open() const
{
    return options_.start_page && options_.start_page->is_open();
}

void LiveWindow::perform_kind(OpenStartPage const&)
{
    if (!options_.start_page || drawings_are_open() || !controller_->may_close(finish()))
        return;
    auto left = leave_drawing();
    options_.start_page->open(std::move(left));
}

// What becomes of it, for the person. It is finished, and kept as far as it can be.
std::string LiveWindow::leave_drawing()
{
    if (recorder_)
        perform_kind(SetRecording { false });
    auto const written = controller_->finish_files();
    auto const& session = controller_->document().session();
    auto const file = session.is_in_file() ? session.path() : std::filesystem::path();
    bool const is_drawn = session.last_step() > 0;
    auto const unnamed = options_.unnamed ? std::exchange(*options_.unnamed, {}) : file;
    go_on_with(OpenedDrawing {}); // The file is closed.
    view().state().title = "tractus";
    if (!written)
        return fmt::format("A file was not written: {}", written.error().message);
    if (!unnamed.empty() && unnamed == file && !is_drawn) {
        remove_if_nothing_was_drawn(unnamed);
        return {};
    }
    if (file.empty())
        return {};
    bool const is_listed = file.parent_path() == user_folder();
    return fmt::format("The drawing is kept as {}", (is_listed ? file.filename() : file).string());
}

// In place of the one at hand; what the window knows of the devices stays.
void LiveWindow::go_on_with(OpenedDrawing drawing)
{
    auto const before = state();
    if (options_.unnamed)
        *options_.unnamed = drawing.unnamed;
    controller_.emplace(station_, std::move(drawing.session), std::move(drawing.scene),
                        options_.folder);
    model_.reset();
    if (!drawing.model.empty())
        follow(drawing.model);
    auto& state = view().state();
    state.live_revision += before.live_revision + 1; // What was shown before is shown no more.
    state.strokes_revision += before.strokes_revision + 1;
    state.skeleton_revision += before.skeleton_revision + 1;
    state.plant_revision += before.plant_revision + 1;
    state.collection_revision += before.collection_revision + 1;
    state.preview_revision += before.preview_revision + 1;
    state.devices_revision += before.devices_revision + 1;
    state.picture_revision += before.picture_revision + 1;
    state.is_live = true;
    state.playing = false;
    state.pen = before.pen;
    state.mouse_draws = before.mouse_draws;
    state.mouse_moves_surface = before.mouse_moves_surface;
    state.may_calibrate = before.may_calibrate;
    state.may_begin_anew = before.may_begin_anew;
    state.cards = before.cards;
    state.title = fmt::format("tractus: {}", drawing.name);
    state.recording.file = before.recording.file;
    if (!drawing.trouble.empty())
        state.status = drawing.trouble;
    else if (auto const& session = controller_->document().session(); session.is_in_file())
        state.status = fmt::format("What is drawn is kept in {}", session.path().string());
}

void LiveWindow::follow_start_page()
{
    if (!drawings_are_open())
        return;
    options_.start_page->advance();
    auto chosen = options_.start_page->take_opened();
    if (!chosen)
        return;
    go_on_with(std::move(chosen->drawing));
    if (chosen->tool)
        perform_kind(ChooseTool { *chosen->tool });
}

void LiveWindow::perform_kind(OpenPictures const&)
{
    open_choices(ChoiceOf::Picture, picture_choices(options_.picture_folders));
}

void LiveWindow::perform_kind(OpenLeaves const&)
{
    std::error_code error;
    auto const cache
        = options_.cache.empty() ? std::filesystem::temp_directory_path(error) : options_.cache;
    drawn_leaves_ = write_drawn_leaves(scene().state, cache);
    open_choices(ChoiceOf::Leaves, leaf_choices(options_.leaves, drawn_leaves_));
}

// A leaf that is drawn in the document is kept among the person's own. No value: it is only kept.
std::optional<std::filesystem::path> LiveWindow::kept_leaf(std::filesystem::path const& chosen)
{
    if (std::ranges::find(drawn_leaves_, chosen) == drawn_leaves_.end() || options_.leaves.empty())
        return chosen;
    auto const kept = keep_leaf(chosen, options_.leaves);
    auto const drawn = drawn_leaves(scene().state);
    bool const is_active = std::ranges::any_of(
        drawn, [&](DrawnLeafGrammar const& leaf) { return leaf.plant == scene().state.active; });
    if (!kept || !is_active)
        return kept ? *kept : chosen;
    view().state().status
        = fmt::format("The leaf is kept as {}: choose the plant that shall have it, and "
                      "then the leaf here again",
                      kept->filename().string());
    return std::nullopt;
}

void LiveWindow::open_choices(ChoiceOf what, Choices choices)
{
    if (!choices_)
        choices_ = std::make_unique<ChoicePage>(options_.cache);
    choice_of_ = what;
    choices_->open(std::move(choices));
}

void LiveWindow::follow_choices()
{
    if (!choices_)
        return;
    choices_->advance();
    auto const file = choices_->take_chosen();
    if (!file)
        return;
    if (choice_of_ == ChoiceOf::Picture)
        perform_kind(LayPictureFile { *file });
    else if (auto const leaf = kept_leaf(*file))
        perform_kind(DressActivePlant { *leaf });
}

// The pen places it next.
void LiveWindow::perform_kind(LayPictureFile const& command)
{
    controller_->perform(command, station_);
    auto const tools = station_.tools();
    auto const placing = std::find_if(tools.begin(), tools.end(),
                                      [](ToolKind const* kind) { return kind->lays_pictures; });
    if (placing != tools.end() && &station_.tool().kind() != *placing)
        perform_kind(ChooseTool { Tool(**placing) });
}

} // namespace tractus
