#include "app/station_desk.h"

#include "app/session/describe_edit.h"

#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

StationDesk::StationDesk(Station const& station, std::optional<Session> session,
                         std::filesystem::path pictures)
    : keeper_(std::move(session))
    , view_(station, std::move(pictures))
{
    view_.state().has_session = keeper_.has_session();
}

void StationDesk::show(Station& station, Timestamp now)
{
    keeper_.keep_strokes(station, now);
    view_.show(station);
    keeper_.forget_kept(station);
    if (auto const& why = keeper_.not_kept(); !why.empty())
        view_.state().trouble = fmt::format("What is drawn is not kept: {}", why);
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

void StationDesk::perform(SavePicture const& command, Station& station)
{
    view_.save(command.picture, station);
}

} // namespace tractus
