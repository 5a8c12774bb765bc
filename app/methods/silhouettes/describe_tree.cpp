#include "app/methods/silhouettes/describe_tree.h"

#include "app/methods/silhouettes/outline_tool.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

std::string counted_branches(std::size_t count)
{
    return fmt::format("{} {}", count, count == 1 ? "branch" : "branches");
}

DrawnOnBranch const* drawn_by(std::vector<DrawnOnBranch> const& drawn, std::uint64_t edit)
{
    auto const found = std::find_if(drawn.begin(), drawn.end(), [&](DrawnOnBranch const& one) {
        return scene::edit_of_item(one.id) == edit;
    });
    return found == drawn.end() ? nullptr : &*found;
}

// Number of branches on the branch with the path `path`; no value if there is no such branch.
std::optional<std::size_t> count_on(OutlinedTree on_trunk, std::string const& path)
{
    on_trunk.form.levels = 1;
    auto const skeleton = skeleton_of(on_trunk);
    if (!skeleton)
        return std::nullopt;
    auto const parent = skeleton->at(path);
    return parent ? std::optional(skeleton->branches_on(*parent)) : std::nullopt;
}

// Sentence about the branch on which the last edit drew; empty if that edit did not draw on a
// branch.
std::string describe_branch(OutlinedTree const& tree, std::uint64_t last_edit)
{
    auto const* const own = drawn_by(tree.own_outlines, last_edit);
    auto const* const drawn = own ? own : drawn_by(tree.own_branches, last_edit);
    if (!drawn)
        return {};
    constexpr std::array kFollow { "", "; its siblings follow",
                                   "; its siblings follow, and what is below" };
    auto const* const follow = kFollow[static_cast<std::size_t>(drawn->style_to)];
    if (own && own->is_leaf)
        return fmt::format("The branch ends in the leaf{}", follow);
    if (!own)
        return fmt::format("The branch bears {} that you drew{}",
                           counted_branches(static_cast<std::size_t>(std::count_if(
                               tree.own_branches.begin(), tree.own_branches.end(),
                               [&](auto const& other) { return other.branch == drawn->branch; }))),
                           follow);
    auto const count = count_on(tree, own->branch);
    return count ? fmt::format("The branch has its own outline: {} in it{}",
                               counted_branches(*count), follow)
                 : std::string();
}

// Part of a sentence: how many lines were drawn on branches that the tree no longer has. Empty if
// there are none.
std::string describe_waiting(OutlinedTree const& tree)
{
    auto const waiting = count_without_effect(tree);
    if (!waiting || *waiting == 0)
        return {};
    return *waiting == 1
        ? "; a line that was drawn on a branch waits for it"
        : fmt::format("; {} lines that were drawn on branches wait for them", *waiting);
}

// Sentence about the number of branches for which the user chose a style.
std::string describe_styles(OutlinedTree const& tree)
{
    return tree.styles.empty()
        ? std::string("Each branch has its own style, or that of all")
        : fmt::format("{} the style of another one{}",
                      tree.styles.size() == 1 ? "1 branch has"
                                              : fmt::format("{} branches have", tree.styles.size()),
                      describe_waiting(tree));
}

} // namespace

std::string describe_tree(tools::Tool const& tool, scene::Scene const& after)
{
    auto const* const tree = outlined_tree(*after.drawn);
    if (!tree)
        return {};
    if (tool.get<OutlineTool>() && tool.get<OutlineTool>()->what == OutlineTool::What::TurnRound)
        return "The line is turned round";
    if (tree->turned_line != 0 && scene::edit_of_item(tree->turned_line) == after.state.last_edit)
        return "The line ran from its tip to its foot and is turned round: touch it with \"Turn "
               "round\" to turn it back";
    if (!tree->has_crown())
        return "A trunk stands: draw the outline of its crown around it, back to where you began";
    if (tree->is_leaf)
        return "The crown is a leaf: touch it once more as a leaf, and it has branches again";
    if (tool.get<OutlineTool>()->what == OutlineTool::What::Carry)
        return describe_styles(*tree);
    if (auto said = describe_branch(*tree, after.state.last_edit); !said.empty())
        return said;
    auto const& axes = after.base->axes;
    auto const on_trunk
        = std::count_if(axes.begin(), axes.end(), [](Axis const& axis) { return axis.order == 1; });
    return fmt::format("The tree has {} branches on its trunk, {} in all{}", on_trunk,
                       axes.size() - 1, describe_waiting(*tree));
}

} // namespace tractus::silhouette
