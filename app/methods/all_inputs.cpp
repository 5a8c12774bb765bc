#include "app/methods/all_inputs.h"

#include "app/methods/leaves/plant_leaves.h"

#include <array>

namespace tractus::methods {

Result<std::optional<std::string>> make_input(std::filesystem::path const& folder,
                                              std::string const& name)
{
    static constexpr std::array kMakers { leaf::make_ordered_leaves };
    for (auto const make : kMakers)
        if (auto made = TRY(make(folder, name)))
            return made;
    return std::nullopt;
}

} // namespace tractus::methods
