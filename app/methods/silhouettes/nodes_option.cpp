#include "app/methods/silhouettes/nodes_option.h"

#include <array>

namespace tractus::silhouette {

void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes)
{
    // Option words, in the order of the enumeration NodesOption.
    static constexpr std::array<tools::OptionWord, 2> kWords { {
        { "nodes_as_at_first", "as at first" },
        { "whole_nodes", "whole" },
    } };
    // BesideGizmo hides the option: no tool that has this option has a gizmo.
    visitor.choice(
        { .words = kWords, .offered = tools::WordOption::Offered::BesideGizmo, .label = "Nodes" },
        nodes);
}

void visit_fills(tools::OptionVisitor& visitor, FillsOption& fills)
{
    // Option words, in the order of the enumeration FillsOption.
    static constexpr std::array<tools::OptionWord, 4> kWords { {
        { "fills_as_at_first", "as at first" },
        { "fills_by_spacing", "by spacing" },
        { "fills_to_outline", "to the outline" },
        { "fills_by_species", "by species" },
    } };
    visitor.choice(
        { .words = kWords, .offered = tools::WordOption::Offered::BesideGizmo, .label = "Fills" },
        fills);
}

} // namespace tractus::silhouette
