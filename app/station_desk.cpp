#include "app/station_desk.h"

#include "app/dated_path.h"
#include "app/plant_file.h"
#include "app/session/describe_edit.h"
#include "app/session_plant.h"
#include "drivers/file.h"

#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

StationDesk::StationDesk(Station const& station, std::optional<Session> session,
                         std::filesystem::path folder)
    : keeper_(std::move(session))
    , view_(station)
    , folder_(std::move(folder))
{
    view_.state().has_session = keeper_.has_session();
}

void StationDesk::show(Station& station, Timestamp now)
{
    show_done();
    keeper_.keep_strokes(station, now);
    view_.show(station);
    keeper_.forget_kept(station);
    if (auto const& why = keeper_.not_kept(); !why.empty())
        view_.state().trouble = fmt::format("What is drawn is not kept: {}", why);
}

void StationDesk::show_done()
{
    view_.show_grown();
    while (auto const written = files_->take())
        view_.state().status
            = *written ? fmt::format("Saved {}", (*written)->string()) : written->error().message;
    view_.state().is_saving = files_->is_busy();
}

void StationDesk::settle()
{
    view_.settle();
    files_->settle();
    show_done();
}

std::filesystem::path StationDesk::new_file(std::string_view ending) const
{
    return dated_path(folder_, view_.grown_scene()->model_name, ending);
}

void StationDesk::show_again(Result<void> const& done, Station const& station,
                             std::string const& status)
{
    if (done)
        view_.begin_again(station);
    view_.state().status = done ? status : done.error().message;
}

void StationDesk::perform(Undo const&, Station& station)
{
    show_again(keeper_.undo(station), station, "Undone");
}

void StationDesk::perform(Redo const&, Station& station)
{
    show_again(keeper_.redo(station), station, "Done again");
}

void StationDesk::perform(NextVariation const&, Station& station)
{
    auto growth = station.scene().growth;
    ++growth.seed;
    set_growth(growth, station, fmt::format("Another one: seed {}", growth.seed));
}

void StationDesk::perform(ChangeGrowth const& command, Station& station)
{
    auto const growth = growth_set_to(command.growth, station.scene().growth);
    if (!growth)
        view_.state().status = growth.error().message;
    else if (command.slider == ChangeGrowth::Slider::Moving)
        view_.preview(*growth);
    else
        set_growth(*growth, station, fmt::format("The plant {}", describe_edit(*growth)));
}

void StationDesk::perform(AskForCollection const& command, Station&)
{
    view_.collect(command.count);
}

void StationDesk::perform(PickVariation const& command, Station& station)
{
    auto growth = station.scene().growth;
    growth.seed = command.seed;
    set_growth(growth, station, fmt::format("This one: seed {}", growth.seed));
}

void StationDesk::set_growth(SetGrowth const& growth, Station& station, std::string const& status)
{
    auto const made = keeper_.make(std::array { Edit(growth) }, station);
    view_.show_growth(station); // Where it was refused, what a slider previewed is gone.
    view_.state().status = made ? status : made.error().message;
}

void StationDesk::perform(SavePicture const& command, Station&)
{
    save(".png", [picture = command.picture](std::filesystem::path const& path) {
        return write_file(path, [&](std::ostream& out) { return write_png(out, picture); });
    });
}

void StationDesk::perform(ExportPlant const& command, Station&)
{
    constexpr std::array kEndings { ".glb", ".obj", ".png" };
    save(kEndings.at(static_cast<std::size_t>(command.format)),
         [scene = view_.grown_scene()](std::filesystem::path const& path) -> Result<void> {
             auto const plant = TRY(shown_plant(*scene));
             TRY(write_plant_file(plant, std::filesystem::path(scene->model_name).stem(), path));
             return {};
         });
}

void StationDesk::save(std::string_view ending,
                       std::function<Result<void>(std::filesystem::path const&)> write)
{
    auto path = new_file(fmt::format("-seed-{}{}", view_.grown_scene()->growth.seed, ending));
    view_.state().status = fmt::format("Writing {}", path.string());
    view_.state().is_saving = true;
    files_->add({ std::move(path), std::move(write) });
}

} // namespace tractus
