#include "app/methods/silhouettes/nodes_option.h"

#include <array>

namespace tractus::silhouette {

void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes)
{
    // Names in the order of NodesOption.
    static constexpr std::array<tools::OptionWord, 2> kWords { {
        { "nodes_as_at_first", "as at first" },
        { "whole_nodes", "whole" },
    } };
    // This place hides the option: none of these tools has a gizmo beside which a button would
    // appear.
    visitor.choice(
        { .words = kWords, .offered = tools::WordOption::Offered::BesideGizmo, .label = "Nodes" },
        nodes);
}

void visit_fills(tools::OptionVisitor& visitor, FillsOption& fills)
{
    // Names in the order of FillsOption.
    static constexpr std::array<tools::OptionWord, 2> kWords { {
        { "fills_as_at_first", "as at first" },
        { "fills_by_spacing", "by spacing" },
    } };
    visitor.choice(
        { .words = kWords, .offered = tools::WordOption::Offered::BesideGizmo, .label = "Fills" },
        fills);
}

} // namespace tractus::silhouette
