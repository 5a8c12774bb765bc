#include "app/live/station_controller.h"

#include "app/dated_path.h"
#include "app/plants/glb_size.h"
#include "app/plants/plant_file.h"
#include "app/plants/session_plant.h"
#include "app/station/orphans.h"
#include "drivers/file.h"

#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

StationController::StationController(Station const& station, std::optional<Session> session,
                                     std::filesystem::path folder)
    : keeper_(std::move(session))
    , view_(station)
    , folder_(std::move(folder))
{
    view_.state().has_session = keeper_.has_session();
    if (keeper_.has_session())
        view_.state().status = keeper_.session().unknown().sentence();
}

void StationController::show(Station& station, Timestamp now)
{
    show_kept(station, now);
    show_files();
}

void StationController::show_kept(Station& station, Timestamp now)
{
    now_ = now;
    keeper_.advance(station, now);
    while (auto const done = keeper_.take_done()) {
        if (done->of == WantedStep::Of::Growth) {
            view_.show_growth(station); // Where it was refused, what a slider previewed is gone.
            view_.state().status = done->status ? *done->status : done->status.error().message;
        } else if (done->status) {
            show_again(station, *done->status);
        } else {
            view_.state().status = done->status.error().message;
        }
    }
    view_.show(station,
               keeper_.is_settled() ? StationView::Strokes::Kept : StationView::Strokes::AsInk);
    keeper_.forget_kept(station);
    if (auto const& why = keeper_.not_kept(); !why.empty())
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

Result<void> StationController::finish(Station& station, Timestamp now)
{
    if (!keeper_.has_session())
        return {};
    keeper_.try_again();
    keeper_.settle(station, now);
    keeper_.forget_kept(station);
    if (keeper_.not_kept().empty()) {
        Result<void> done;
        while (auto const step = keeper_.take_done())
            if (done && !step->status)
                done = tl::unexpected(step->status.error());
        return done;
    }
    auto const count = keeper_.unkept_strokes();
    auto const what = count == 1 ? std::string("the last stroke is")
                                 : fmt::format("the last {} strokes are", count);
    return fail(Fault::User, fmt::format("{} not kept: {}", what, keeper_.not_kept()));
}

bool StationController::may_close(Result<void> const& finished)
{
    if (finished || std::exchange(knows_what_is_lost_, true))
        return true;
    view_.state().status = fmt::format("Not closed, since {}. Make room for it, or close once more "
                                       "to leave without it",
                                       finished.error().message);
    return false;
}

Result<void> StationController::finish_files()
{
    Result<void> done;
    if (!files_) // Moved from.
        return done;
    files_->settle();
    while (auto const written = files_->take())
        if (done && !*written)
            done = tl::unexpected(written->error());
    view_.state().is_saving = false;
    return done;
}

void StationController::settle(Station& station, Timestamp now)
{
    keeper_.settle(station, now);
    show_kept(station, now);
    view_.settle();
    files_->settle();
    show_files();
}

std::filesystem::path StationController::new_file(std::string_view ending) const
{
    return dated_path(folder_, view_.grown_scene()->model_name, ending);
}

void StationController::show_again(Station const& station, std::string const& status)
{
    view_.begin_again(station);
    view_.state().status = status;
}

void StationController::perform(Undo const&, Station& station)
{
    keeper_.undo();
    show_kept(station, now_);
}

void StationController::perform(Redo const&, Station& station)
{
    keeper_.redo();
    show_kept(station, now_);
}

void StationController::perform(TakeOrphansAway const&, Station& station)
{
    auto const without = [](Scene const& scene) -> Result<WantedStep::Change> {
        auto edits = edits_without_orphans(scene);
        if (edits.empty())
            return fail(Fault::User, "nothing waits for a branch that the plant has lost");
        return WantedStep::Change { std::move(edits), "What had lost its branch is gone" };
    };
    keeper_.make({ without, WantedStep::Of::Scene });
    show_kept(station, now_);
}

void StationController::perform(Restart const&, Station& station)
{
    keeper_.begin_again("The session is as it began");
    show_kept(station, now_);
}

void StationController::perform(NextVariation const&, Station& station)
{
    auto const next = [](SetGrowth growth) -> Result<WantedStep::Change> {
        ++growth.seed;
        return WantedStep::Change { { growth }, fmt::format("Another one: seed {}", growth.seed) };
    };
    set_growth(next, station);
}

void StationController::perform(ChangeGrowth const& command, Station& station)
{
    if (command.slider == ChangeGrowth::Slider::Moving) {
        auto const seen = growth_set_to(command.growth, station.scene().growth);
        if (seen)
            view_.preview(*seen);
        else
            view_.state().status = seen.error().message;
        return;
    }
    auto const set = [wanted = command.growth](SetGrowth growth) -> Result<WantedStep::Change> {
        growth = TRY(growth_set_to(wanted, std::move(growth)));
        auto status = fmt::format("The plant {}", Edit(growth).describe());
        return WantedStep::Change { { growth }, std::move(status) };
    };
    set_growth(set, station);
}

void StationController::perform(AskForCollection const& command, Station&)
{
    view_.collect(command.count);
}

void StationController::perform(PickVariation const& command, Station& station)
{
    auto const pick = [seed = command.seed](SetGrowth growth) -> Result<WantedStep::Change> {
        growth.seed = seed;
        return WantedStep::Change { { growth }, fmt::format("This one: seed {}", seed) };
    };
    set_growth(pick, station);
}

// `change` is asked when what was wanted before is done.
void StationController::set_growth(
    std::function<Result<WantedStep::Change>(SetGrowth growth)> const& change, Station& station)
{
    keeper_.make(
        { [=](Scene const& scene) { return change(scene.growth); }, WantedStep::Of::Growth });
    show_kept(station, now_);
}

void StationController::perform(SavePicture const& command, Station&)
{
    save(".png",
         [picture = command.picture](std::filesystem::path const& path) -> Result<std::string> {
             TRY(write_file(path, [&](std::ostream& out) { return write_png(out, picture); }));
             return std::string();
         });
}

void StationController::perform(ExportPlant const& command, Station&)
{
    constexpr std::array kEndings { ".glb", ".obj" };
    save(kEndings.at(static_cast<std::size_t>(command.format)),
         [scene = view_.grown_scene(),
          organs = command.organs](std::filesystem::path const& path) -> Result<std::string> {
             PlantFileOptions options { .glb = { .organs = organs } };
             std::string note;
             options.glb.before_writing = [&](GlbSummary const& expected) {
                 note = large_glb_size(expected).value_or("");
                 if (!note.empty() && organs != GlbOptions::Organs::Instanced)
                     note += "; with its leaves instanced it is smaller";
             };
             auto const plant = TRY(shown_plant(*scene));
             TRY(write_plant_file(plant, std::filesystem::path(scene->model_name).stem(), path,
                                  options));
             return note;
         });
}

void StationController::save(std::string_view ending,
                             std::function<Result<std::string>(std::filesystem::path const&)> write)
{
    auto path = new_file(fmt::format("-seed-{}{}", view_.grown_scene()->growth.seed, ending));
    view_.state().status = fmt::format("Writing {}", path.string());
    view_.state().is_saving = true;
    files_->add({ std::move(path), std::move(write) });
}

} // namespace tractus
