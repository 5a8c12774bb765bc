#include "app/controllers/station_controller.h"

#include "app/batch/plant_file.h"
#include "app/batch/plant_group.h"
#include "app/batch/plant_season.h"
#include "app/controllers/drawing_name.h"
#include "app/controllers/picture_files.h"
#include "app/controllers/rules_file.h"
#include "app/controllers/unnamed_session.h"
#include "app/files/dated_path.h"
#include "app/io/glb_size.h"
#include "app/methods/all_leaves.h"
#include "app/methods/all_organs.h"
#include "app/session/session_copy.h"
#include "app/view/orphans.h"
#include "engine/base/file.h"
#include "engine/scene/derive_anew.h"

#include <chrono>
#include <fmt/core.h>
#include <utility>

namespace tractus::controllers {

static std::unique_ptr<document::Document> document_of(std::optional<session::Session> session,
                                                       scene::Scene scene)
{
    constexpr auto kWorking = document::Document::Working::OnItsThread;
    if (session)
        return std::make_unique<document::Document>(*std::move(session), kWorking,
                                                    batch::following_edits);
    return std::make_unique<document::Document>(std::move(scene), kWorking, batch::following_edits);
}

StationController::StationController(station::Station const& station,
                                     std::optional<session::Session> session, scene::Scene scene,
                                     std::filesystem::path folder)
    : document_(document_of(std::move(session), std::move(scene)))
    , view_(station, *document_)
    , folder_(std::move(folder))
{
    view_.state().has_session = document_->session().is_in_file();
    view_.state().export_endings = batch::plant_endings();
    std::erase(view_.state().export_endings, ".png"); // The window saves its own view as a picture.
    show_name();
    view_.state().status = document_->session().unknown().sentence();
}

void StationController::show(station::Station& station, Timestamp now)
{
    show_document(station, now);
    show_files();
}

void StationController::take_strokes(station::Station& station)
{
    for (auto& stroke : station.take_strokes())
        document_->draw(std::move(stroke));
    announce_dab(station);
}

// Explains why a dab (a touch too short for a stroke) had no effect, once per kind of tool.
void StationController::announce_dab(station::Station const& station)
{
    auto const* const kind = station.last_dab();
    bool const is_new
        = std::exchange(reported_dabs_, station.counts().dabs) < station.counts().dabs;
    if (!is_new || !tools_with_reported_dabs_.insert(kind).second)
        return;
    view_.state().status
        = tools::describe_dab(*kind, tools::min_extent_mm(station.min_extents(), *kind));
}

// Returns the tool to select if the options of the plant's tool changed with the scene and the
// selected tool had them before; otherwise nullopt.
static std::optional<tools::Tool> hand_after(tools::Tool const& hand, scene::Scene const& before,
                                             scene::Scene const& after)
{
    auto* const like_drawn = hand.kind().like_drawn;
    if (!like_drawn || like_drawn(hand, before) != hand)
        return std::nullopt;
    auto tool = like_drawn(hand, after);
    return tool != hand ? tool : std::nullopt;
}

void StationController::show_document(station::Station& station, Timestamp now)
{
    now_ = now;
    take_strokes(station);
    document_->pass_time(now);
    auto const before = view_.grown_scene();
    bool has_travelled = false;
    for (auto const& drawn : document_->take_finished_strokes())
        view_.tell(drawn);
    while (auto done = document_->take_done()) {
        if (!done->status && done->of == document::StepRequest::Of::Growth)
            view_.show_growth();
        else if (!done->status)
            view_.propose({});
        has_travelled |= done->status && done->what != document::LoggedStep::What::Edits;
        view_.state().status = done->status ? *done->status : done->status.error().message;
        if (done->status)
            done_.push_back(*std::move(done));
    }
    view_.show(station, *document_);
    auto const* const plant = scene::active_plant(document_->newest()->scene.state);
    view_.state().may_write_rules = plant && plant->source.accepts_rules();
    if (has_travelled)
        hand_ = hand_after(station.tool(), *before, *view_.grown_scene());
    if (auto const& why = document_->newest()->not_kept; !why.empty())
        view_.state().trouble = fmt::format("What is drawn is not kept: {}", why);
}

void StationController::show_files()
{
    while (auto const written = files_->take()) {
        if (!*written) {
            view_.state().status = written->error().message;
            continue;
        }
        auto const& [path, note] = **written;
        view_.state().status
            = fmt::format("Saved {}{}{}", path.string(), note.empty() ? "" : ": ", note);
    }
    view_.state().is_saving = files_->is_busy();
}

Result<void> StationController::finish(station::Station& station, Timestamp now)
{
    if (!document_) // This object was moved from: there is nothing to finish.
        return {};
    take_strokes(station);
    document_->try_again();
    document_->settle();
    show_document(station, now);
    auto const snapshot = document_->newest();
    if (snapshot->unkept == 0)
        return {};
    auto const what = snapshot->unkept == 1
        ? std::string("the last stroke is")
        : fmt::format("the last {} strokes are", snapshot->unkept);
    return fail(Fault::User, fmt::format("{} not kept: {}", what, snapshot->not_kept));
}

bool StationController::may_close(Result<void> const& finished)
{
    if (finished || std::exchange(has_warned_of_loss_, true))
        return true;
    view_.state().status = fmt::format("Not closed, since {}. Make room for it, or close once more "
                                       "to leave without it",
                                       finished.error().message);
    return false;
}

Result<void> StationController::finish_files()
{
    Result<void> done;
    if (!files_) // This object was moved from: there are no files.
        return done;
    files_->settle();
    while (auto const written = files_->take())
        if (done && !*written)
            done = tl::unexpected(written->error());
    view_.state().is_saving = false;
    return done;
}

void StationController::settle(station::Station& station, Timestamp now)
{
    take_strokes(station);
    document_->settle();
    show_document(station, now);
    view_.settle();
    files_->settle();
    show_files();
}

std::filesystem::path StationController::new_file(std::string_view ending) const
{
    return files::dated_path(folder_, view_.grown_scene()->model_name, ending);
}

void StationController::show_again(station::Station const& station, std::string const& status)
{
    view_.begin_again(station, *document_);
    view_.state().status = status;
}

void StationController::perform(view::Undo const&, station::Station& station)
{
    document_->undo();
    show_document(station, now_);
}

void StationController::perform(view::Redo const&, station::Station& station)
{
    document_->redo();
    show_document(station, now_);
}

void StationController::perform(view::TakeOrphansAway const&, station::Station& station)
{
    auto const without = [](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        auto edits = view::edits_without_orphans(scene);
        if (edits.empty())
            return fail(Fault::User, "nothing waits for a branch that the plant has lost");
        return document::StepRequest::Change { std::move(edits),
                                               "What had lost its branch is gone" };
    };
    document_->make({ without, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::PickCurve const& command, station::Station& station)
{
    auto const& curves = view_.state().curves;
    if (command.curve >= curves.size())
        return;
    auto const& curve = curves[command.curve];
    if (curve.paths.empty()) {
        view_.state().status = curve.name;
        return;
    }
    auto const select = [at = curve.paths, name = curve.name](scene::Scene const&) {
        return Result<document::StepRequest::Change>(
            { { scene::Select { .at = at } },
              fmt::format("Selected what a stroke shapes: {}", name) });
    };
    document_->make({ select, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

// Lays a picture behind the drawing. The document's thread reads the picture when it makes the
// step, as reading a large one takes time.
void StationController::perform(view::LayPictureFile const& command, station::Station& station)
{
    auto const change = [file = command.file, tablet_mm = view_.state().surface_size_mm()](
                            scene::Scene const&) -> Result<document::StepRequest::Change> {
        auto edit = TRY(load_back_picture(file, tablet_mm));
        auto status = fmt::format("{} lies behind what is drawn", edit.name);
        return document::StepRequest::Change { { std::move(edit) }, std::move(status) };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::DragDrawnGizmo const& command, station::Station& station)
{
    auto const* const kind = station.tool().kind().drawn_gizmo;
    if (!kind)
        return;
    if (command.slider == view::ChangeGrowth::Slider::Moving) {
        if (auto edits = kind->drag(*view_.grown_scene(), command.handle, command.to))
            view_.propose(*std::move(edits));
        else
            view_.state().status = edits.error().message;
        return;
    }
    auto const change
        = [kind, command](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        auto edits = TRY(kind->drag(scene, command.handle, command.to));
        return document::StepRequest::Change { std::move(edits), "What was drawn follows" };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

// Describes the chosen foliage to the user.
static std::string leaves_in_words(methods::Foliage const& wanted)
{
    if (wanted.drawn != 0)
        return "leaves like the one that is drawn, and follows it";
    return wanted.leaves.empty()
        ? std::string("its own leaves")
        : fmt::format("leaves of {}", std::filesystem::path(wanted.leaves).stem().string());
}

void StationController::perform(view::SetActiveFoliage const& command, station::Station& station)
{
    methods::Foliage const wanted { .leaves = methods::leaves_of_grammar(command.leaves),
                                    .drawn = command.drawn,
                                    .age = command.age,
                                    .damage = command.damage };
    auto const change = [wanted, season = command.season](
                            scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        if (!scene::active_plant(scene.state))
            return fail(Fault::User, "There is no plant yet: draw one first");
        auto edits = TRY(methods::foliage_edits(scene, scene.state.active, wanted));
        // In a season, the season determines the leaves' ages instead of the chosen age.
        if (auto const then = season.value_or(scene.state.season); then || season) {
            auto const foliated = TRY(scene::apply_edits(scene, edits));
            for (auto& edit : TRY(batch::season_edits(foliated, then)))
                edits.push_back(std::move(edit));
        }
        return document::StepRequest::Change {
            std::move(edits), fmt::format("The plant has {}", leaves_in_words(wanted))
        };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::BringLeaf const& command, station::Station& station)
{
    auto const change =
        [file = command.file](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        auto edits = TRY(methods::organ_edits(scene, file));
        scene::SceneBuilder builder(scene, {});
        auto const after = TRY(scene::apply_edits(scene.state, edits, builder));
        return document::StepRequest::Change { std::move(edits), methods::describe_organ(after) };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::begin_again(station::Station& station, std::string const& status,
                                    document::Document::Growth growth)
{
    document_->begin_again(
        document_->session().is_in_file() ? "The session is as it began" : status, growth);
    show_document(station, now_);
}

void StationController::take_model(Result<scene::LoadModel> model, station::Station& station)
{
    if (!model) {
        view_.state().status = model.error().message;
        return;
    }
    auto const change = [model = *std::move(model)](scene::Scene const& scene) {
        return take_rules(model, scene);
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

static std::vector<scene::Edit> following(tools::Tool const& before, tools::Tool const& after,
                                          scene::Scene const& scene)
{
    auto* const follow = after.kind().follow;
    return follow && &before.kind() == &after.kind() ? follow(before, after, scene)
                                                     : std::vector<scene::Edit>();
}

void StationController::preview_following(tools::Tool const& before, tools::Tool const& after)
{
    view_.propose(following(before, after, *view_.grown_scene()));
}

void StationController::let_follow(tools::Tool const& before, tools::Tool const& after,
                                   station::Station& station)
{
    if (following(before, after, *view_.grown_scene()).empty())
        return view_.propose({});
    auto const change = [=](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        auto edits = following(before, after, scene);
        if (edits.empty())
            return fail(Fault::User, "what was drawn so is gone");
        auto status = edits.size() == 1 ? std::string("What was drawn so follows")
                                        : fmt::format("{} that were drawn so follow", edits.size());
        return document::StepRequest::Change { std::move(edits), std::move(status) };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::NextVariation const&, station::Station& station)
{
    auto const next = [](scene::SetGrowth growth) -> Result<document::StepRequest::Change> {
        ++growth.seed;
        return document::StepRequest::Change { { growth },
                                               fmt::format("Another one: seed {}", growth.seed) };
    };
    set_growth(next, station);
}

void StationController::perform(view::ChangeGrowth const& command, station::Station& station)
{
    if (command.slider == view::ChangeGrowth::Slider::Moving) {
        auto const seen
            = view::with_growth_settings(command.growth, document_->newest()->scene.growth);
        if (seen)
            view_.preview(*seen);
        else
            view_.state().status = seen.error().message;
        return;
    }
    auto const set = [wanted = command.growth](
                         scene::SetGrowth growth) -> Result<document::StepRequest::Change> {
        growth = TRY(view::with_growth_settings(wanted, std::move(growth)));
        auto status = fmt::format("The plant {}", scene::Edit(growth).describe());
        return document::StepRequest::Change { { growth }, std::move(status) };
    };
    set_growth(set, station);
}

void StationController::perform(view::ChangeSeason const& command, station::Station& station)
{
    if (command.slider == view::ChangeGrowth::Slider::Moving)
        return view_.preview(command.season);
    auto const change = [season = command.season](
                            scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        auto edits = TRY(batch::season_edits(scene, season));
        auto status = season ? fmt::format("It is {}", scene::month_name(season->month))
                             : std::string("No season: leaves as the models have them");
        return document::StepRequest::Change { std::move(edits), std::move(status) };
    };
    document_->make({ change, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::RequestCollection const& command, station::Station&)
{
    view_.collect(command);
}

void StationController::perform(view::PickVariation const& command, station::Station& station)
{
    auto const pick = [seed = command.seed, share = view_.state().individuality.seeds](
                          scene::Scene const& scene) -> Result<document::StepRequest::Change> {
        if (scene.base->axes.empty())
            return fail(Fault::User, "There is no plant yet: draw one first");
        std::vector<scene::Edit> edits;
        if (auto anew = scene::derive_anew(scene, { seed, 0 }, share))
            edits.emplace_back(*std::move(anew));
        auto growth = scene.growth;
        growth.seed = seed;
        edits.emplace_back(growth);
        return document::StepRequest::Change { std::move(edits),
                                               fmt::format("This one: seed {}", seed) };
    };
    document_->make({ pick, document::StepRequest::Of::Scene });
    show_document(station, now_);
}

void StationController::perform(view::SetAlongGround const& command, station::Station&)
{
    view_.set_along_ground(command.is_on);
    view_.state().status = command.is_on ? "Growth bends along the ground"
                                         : "Growth is as it is, into the ground, too";
}

// Changes the growth as an undoable step. `change` is called after all earlier steps are done.
void StationController::set_growth(
    std::function<Result<document::StepRequest::Change>(scene::SetGrowth growth)> const& change,
    station::Station& station)
{
    document_->make({ [=](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
                         bool const is_empty = scene.plants.empty() && scene.base->axes.empty();
                         return is_empty
                             ? fail(Fault::User, "There is no plant yet: draw one first")
                             : change(scene.growth);
                     },
                      document::StepRequest::Of::Growth });
    show_document(station, now_);
}

void StationController::perform(view::SavePicture const& command, station::Station&)
{
    save(".png",
         [picture = command.picture](std::filesystem::path const& path) -> Result<std::string> {
             TRY(write_file(path,
                            [&](std::ostream& out) { return render::write_png(out, picture); }));
             return std::string();
         });
}

void StationController::perform(view::ExportPlant const& command, station::Station&)
{
    save(command.ending,
         [scene = view_.grown_scene(), organs = command.organs,
          along_ground
          = view_.state().along_ground](std::filesystem::path const& path) -> Result<std::string> {
             batch::PlantFileOptions options { .glb = { .organs = organs } };
             std::string note;
             options.glb.before_writing = [&](exports::GlbSummary const& expected) {
                 note = io::large_glb_size(expected).value_or("");
                 if (!note.empty() && organs != exports::GlbOptions::Organs::Instanced)
                     note += "; with its leaves instanced it is smaller";
             };
             auto const plant = TRY(batch::shown_plants(*scene, along_ground));
             auto const written = TRY(batch::write_plant_file(
                 plant, std::filesystem::path(scene->model_name).stem(), path, options));
             return note.empty() ? written.note : note;
         });
}

// Shows the drawing's name: the session's own name, otherwise one made from the file's name.
void StationController::show_name()
{
    auto const& session = document_->session();
    auto& state = view_.state();
    state.drawing_name.reset();
    if (session.is_in_file())
        state.drawing_name = name_of_drawing(session.path(), session.name());
}

void StationController::perform(view::NameDrawing const& command, station::Station&)
{
    auto const named
        = [&]() -> Result<void> { return document_->set_name(TRY(name_as_typed(command.name))); }();
    auto& state = view_.state();
    show_name();
    state.status = named ? fmt::format("The drawing is called {}", *state.drawing_name)
                         : named.error().message;
    if (named)
        state.title = fmt::format("tractus: {}", *state.drawing_name);
}

// Saves a copy of the session, including everything drawn before the command.
void StationController::perform(view::SaveCopy const& command, station::Station& station)
{
    auto const begin = [&]() -> Result<void> {
        auto const name = TRY(name_as_typed(command.name));
        TRY(finish(station, now_));
        if (!document_->session().is_in_file())
            return fail(Fault::User,
                        "there is no file to copy: what is drawn is kept in memory "
                        "alone");
        auto const now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
        auto path = TRY(unnamed_session_path(file_name_of(name), now));
        view_.state().status = fmt::format("Writing {}", path.string());
        view_.state().is_saving = true;
        files_->add({ std::move(path),
                      [name, from = document_->session().path()](
                          std::filesystem::path const& copy) -> Result<std::string> {
                          TRY(session::copy_session(from, copy, name));
                          return std::string();
                      } });
        return {};
    }();
    if (!begin)
        view_.state().status = begin.error().message;
}

// Writes the active plant's rules as a file. From then on, changes to the file update the plant.
void StationController::perform(view::WriteRules const&, station::Station& station)
{
    auto const written = [&]() -> Result<std::filesystem::path> {
        TRY(finish(station, now_));
        auto const* const plant = scene::active_plant(document_->newest()->scene.state);
        return write_rules(plant ? *plant : scene::PlantState(), new_file("-rules"));
    }();
    view_.state().status = written
        ? fmt::format("Write in {} with any editor: the plant follows when it is saved",
                      written->string())
        : written.error().message;
    if (written)
        rules_file_ = *written;
}

std::optional<std::filesystem::path> StationController::take_rules_file()
{
    return std::exchange(rules_file_, std::nullopt);
}

void StationController::save(std::string_view ending,
                             std::function<Result<std::string>(std::filesystem::path const&)> write)
{
    auto path = new_file(fmt::format("-seed-{}{}", view_.grown_scene()->growth.seed, ending));
    view_.state().status = fmt::format("Writing {}", path.string());
    view_.state().is_saving = true;
    files_->add({ std::move(path), std::move(write) });
}

} // namespace tractus::controllers
