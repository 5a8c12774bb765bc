#include "engine/methods/silhouettes/skeleton.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace tractus::silhouette {

std::size_t Skeleton::branch_count() const
{
    std::function<std::size_t(std::size_t)> const count_in = [&](std::size_t system) {
        std::size_t count = 0;
        for (auto const below : system_of[system])
            count += 1 + (below == kNoSystem ? 0 : count_in(below));
        return count;
    };
    return systems.empty() ? 0 : count_in(0);
}

std::size_t Skeleton::branches_on(BranchRef const& branch) const
{
    auto const below = system_of[branch.system][branch.branch];
    return below == kNoSystem ? 0 : systems[below].branches.size();
}

std::optional<BranchRef> Skeleton::at(std::string_view path) const
{
    std::size_t system = 0;
    while (system != kNoSystem) {
        auto const end = std::min(path.find(kPathSeparator), path.size());
        auto const branch = number_of(systems[system], std::string(path.substr(0, end)));
        if (!branch)
            return std::nullopt;
        if (end == path.size())
            return BranchRef { system, *branch };
        path.remove_prefix(end + 1);
        system = system_of[system][*branch];
    }
    return std::nullopt;
}

std::string Skeleton::path_of(BranchRef const& branch) const
{
    auto const name = name_of(systems[branch.system].branches[branch.branch]);
    auto const& parent = parents[branch.system];
    return parent.empty() ? name : parent + kPathSeparator + name;
}

std::vector<std::size_t> Skeleton::drawn_systems() const
{
    std::vector<std::size_t> drawn { 0 };
    for (std::size_t i = 0; i < drawn.size(); ++i)
        for (std::size_t b = 0; b < systems[drawn[i]].branches.size(); ++b) {
            auto const below = system_of[drawn[i]][b];
            auto const& branch = systems[drawn[i]].branches[b];
            if (below != kNoSystem && !branch.model && branch.is_refined())
                drawn.push_back(below);
        }
    return drawn;
}

std::string_view parent_in(std::string_view path)
{
    auto const end = path.rfind(kPathSeparator);
    return end == std::string_view::npos ? std::string_view() : path.substr(0, end);
}

std::string_view last_name_in(std::string_view path)
{
    // Returns the whole path if there is no separator, because npos + 1 is 0.
    return path.substr(path.rfind(kPathSeparator) + 1);
}

std::optional<std::size_t> number_of(BranchingSystem const& system, std::string const& name)
{
    for (std::size_t i = 0; i < system.branches.size(); ++i)
        if (name_of(system.branches[i]) == name)
            return i;
    return std::nullopt;
}

std::string name_of(Branch const& branch)
{
    if (!branch.name.empty())
        return branch.name;
    switch (branch.origin) {
    case Branch::Origin::Bump:
        return fmt::format("b{}", branch.number);
    case Branch::Origin::Copy:
        return fmt::format("{}{}", branch.number % 2 == 0 ? 'L' : 'R', branch.number / 2);
    case Branch::Origin::Gap:
        return fmt::format("g{}", branch.number);
    case Branch::Origin::Spaced:
        return fmt::format("s{}", branch.number);
    case Branch::Origin::Drawn:
        return fmt::format("d{}", branch.number);
    case Branch::Origin::Apex:
        break;
    }
    return "apex";
}

} // namespace tractus::silhouette
