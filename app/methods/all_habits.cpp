#include "app/methods/all_habits.h"

#include "app/methods/self_organising/habit_file.h"
#include "engine/methods/self_organising/grown_tree.h"

namespace tractus::methods {

std::vector<std::string> habit_names()
{
    return self_organising::habit_names();
}

Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed)
{
    return scene::Edit(
        self_organising::PlantTree { .habit = TRY(self_organising::load_habit(habit)),
                                     .seed = seed,
                                     .first = { .years = years } });
}

} // namespace tractus::methods
