#include "app/controllers/live_window.h"

#include "app/controllers/drawn_leaf_files.h"
#include "app/controllers/unnamed_session.h"
#include "app/files/user_folder.h"
#include "app/methods/all_leaves.h"
#include "app/methods/all_organs.h"
#include "app/tools/tool_choices.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

// This file contains the pages that replace the drawing in the window, and their commands.
namespace tractus::controllers {

view::StartPageModel* LiveWindow::start_page()
{
    if (leaf_page_ && leaf_page_->is_open())
        return leaf_page_.get();
    if (choices_ && choices_->is_open())
        return choices_.get();
    return drawings_are_open() ? options_.start_page.get() : nullptr;
}

bool LiveWindow::drawings_are_open() const
{
    return options_.start_page && options_.start_page->is_open();
}

void LiveWindow::perform_kind(view::OpenStartPage const&)
{
    if (!options_.start_page || drawings_are_open() || !controller_->may_close(finish()))
        return;
    perform_kind(view::EndTour {});
    auto left = leave_drawing();
    options_.start_page->open(std::move(left));
}

// Finishes the drawing, saves as much of it as possible, and returns a message about the result.
std::string LiveWindow::leave_drawing()
{
    if (recorder_)
        perform_kind(view::SetRecording { false });
    auto const written = controller_->finish_files();
    auto const& session = controller_->document().session();
    auto const file = session.is_in_file() ? session.path() : std::filesystem::path();
    bool const is_drawn = session.last_step() > 0;
    auto const unnamed = options_.unnamed ? std::exchange(*options_.unnamed, {}) : file;
    go_on_with(OpenedDrawing {}); // Opening an empty drawing closes the session's file.
    view().state().title = "tractus";
    if (!written)
        return fmt::format("A file was not written: {}", written.error().message);
    if (!unnamed.empty() && unnamed == file && !is_drawn) {
        remove_if_nothing_was_drawn(unnamed);
        return {};
    }
    if (file.empty())
        return {};
    bool const is_listed = file.parent_path() == files::user_folder();
    return fmt::format("The drawing is kept as {}", (is_listed ? file.filename() : file).string());
}

// Opens another drawing instead of the current one. Information about the devices stays in the
// window's state.
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
    // Increases all revisions, so that the window does not take earlier contents for current ones.
    state.live_revision += before.live_revision + 1;
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
    state.is_hand_simulated = before.is_hand_simulated;
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
        perform_kind(view::ChooseTool { *chosen->tool });
    else
        take_tool_for_drawing();
    if (chosen->is_for_tour)
        perform_kind(view::BeginTour {});
}

// Selects the tool that suits this drawing, unless it is already selected.
void LiveWindow::take_tool_for_drawing()
{
    auto const tool
        = tools::tool_for_drawing(station_.tools(), controller_->document().newest()->scene);
    if (tool != station_.tool())
        perform_kind(view::ChooseTool { tool });
}

void LiveWindow::perform_kind(view::OpenPictures const&)
{
    open_choices(ChoiceOf::Picture, picture_choices(options_.picture_folders));
}

void LiveWindow::perform_kind(view::OpenLeaves const&)
{
    open_choices(ChoiceOf::Leaves, leaf_choices(options_.leaves, leaves_in_document()));
}

static bool is_drawn_leaf(scene::Scene const& scene, scene::ItemId plant)
{
    return std::ranges::any_of(
        methods::drawn_leaves(scene.state),
        [&](methods::DrawnLeafGrammar const& leaf) { return leaf.plant == plant; });
}

// Returns the document's leaves, written as files for the page of choices.
LeavesInDocument LiveWindow::leaves_in_document()
{
    std::error_code error;
    auto const cache
        = options_.cache.empty() ? std::filesystem::temp_directory_path(error) : options_.cache;
    auto const& state = scene().state;
    drawn_leaves_ = write_drawn_leaves(state, cache);
    drawn_organs_ = write_drawn_organs(state, cache);
    LeavesInDocument leaves { .takes_views = methods::takes_organs(state) };
    char const* const keeps = "Choosing it keeps it among yours";
    for (auto const& drawn : drawn_leaves_)
        leaves.drawn.push_back(
            { drawn.file,
              is_drawn_leaf(scene(), state.active) ? keeps : "The plant follows its drawing" });
    for (auto const& drawn : drawn_organs_)
        leaves.in_views.push_back(
            { drawn.file, inserts_leaf(drawn.file) ? "Of another plant, for this one" : keeps });
    kept_leaf_.clear();
    if (auto const worn = methods::chosen_foliage(state, state.active))
        if (auto const kept = state.leaf_grammars.find(worn->leaves);
            kept != state.leaf_grammars.end())
            if (auto const file = write_shown_leaf("worn-leaf.leaf", *kept->second, cache))
                kept_leaf_ = *file;
    leaves.kept = kept_leaf_;
    return leaves;
}

// True if a chosen leaf, drawn in three views, should be put on the active plant: the plant accepts
// such leaves, and the leaf is not its own.
bool LiveWindow::inserts_leaf(std::filesystem::path const& file)
{
    auto const& state = scene().state;
    return methods::takes_organs(state)
        && std::ranges::none_of(drawn_organs_, [&](DrawnOrganFile const& drawn) {
               return drawn.file == file && drawn.plant == state.active;
           });
}

// Saves a drawn leaf in the user's folder of leaves; used if no active plant can carry it.
void LiveWindow::keep_drawn_leaf(std::filesystem::path const& file)
{
    Result<std::filesystem::path> kept = fail(Fault::User, "There is no folder for leaves");
    if (!options_.leaves.empty())
        kept = keep_leaf(file, options_.leaves);
    view().state().status = kept
        ? fmt::format("The leaf is kept as {}: choose the plant that shall have it, and "
                      "then the leaf here again",
                      kept->filename().string())
        : kept.error().message;
}

// Opens the page that previews leaves. It begins with the plant's current foliage if that uses this
// grammar, otherwise with fully grown, undamaged leaves.
void LiveWindow::open_leaf_page(std::filesystem::path const& file)
{
    auto const& state = scene().state;
    methods::Foliage wanted { .leaves = methods::leaves_of_grammar(file.string()) };
    auto const drawn = std::ranges::find(drawn_leaves_, file, &DrawnLeafFile::file);
    auto const worn = methods::chosen_foliage(state, state.active);
    if (drawn != drawn_leaves_.end())
        wanted = { .drawn = drawn->leaf };
    else if (file == kept_leaf_ && worn)
        wanted.leaves = worn->leaves;
    if (worn && worn->leaves == wanted.leaves && worn->drawn == wanted.drawn)
        wanted = *worn;
    auto grammar = methods::grammar_of(state, wanted);
    if (!grammar) {
        view().state().status = grammar.error().message;
        return;
    }
    auto const name = file.stem().string();
    if (!leaf_page_)
        leaf_page_ = std::make_unique<LeafPage>();
    leaf_page_->open(
        { .title = wanted.drawn != 0 ? std::string("Your leaf") : fmt::format("Leaves: {}", name),
          .grammar = *std::move(grammar),
          .wanted = std::move(wanted),
          .season = state.season });
}

void LiveWindow::follow_leaf_page()
{
    if (!leaf_page_)
        return;
    leaf_page_->advance();
    if (auto const accepted = leaf_page_->take_accepted())
        perform(*accepted);
    else if (leaf_page_->take_left())
        perform_kind(view::OpenLeaves {});
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
    bool const is_drawn
        = std::ranges::find(drawn_leaves_, *file, &DrawnLeafFile::file) != drawn_leaves_.end();
    if (choice_of_ == ChoiceOf::Picture)
        perform_kind(view::LayPictureFile { *file });
    else if (file->empty())
        perform_kind(view::SetActiveFoliage {});
    else if (methods::is_organ_file(*file) && inserts_leaf(*file))
        perform_kind(view::BringLeaf { *file });
    else if (methods::is_organ_file(*file)
             || (is_drawn && is_drawn_leaf(scene(), scene().state.active)))
        keep_drawn_leaf(*file);
    else
        open_leaf_page(*file);
}

// Lays the picture behind the drawing; the pen's next stroke places it.
void LiveWindow::perform_kind(view::LayPictureFile const& command)
{
    controller_->perform(command, station_);
    auto const tools = station_.tools();
    auto const placing = std::find_if(tools.begin(), tools.end(), [](tools::ToolKind const* kind) {
        return kind->lays_pictures;
    });
    if (placing != tools.end() && &station_.tool().kind() != *placing)
        perform_kind(view::ChooseTool { tools::Tool(**placing) });
}

} // namespace tractus::controllers
