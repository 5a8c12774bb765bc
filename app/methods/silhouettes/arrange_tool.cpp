#include "app/methods/silhouettes/arrange_tool.h"

#include "app/methods/silhouettes/erase_outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <array>
#include <cmath>

namespace tractus::silhouette {

namespace {

// Option words, in the order of the enumeration To: "next", then the patterns in the order of the
// enumeration Pattern::Kind.
constexpr std::array<tools::OptionWord, 7> kTo { {
    { "next", "Next", nullptr, true },
    { "even", "Even", nullptr, true },
    { "spiral", "Spiral", nullptr, true },
    { "decussate", "Decussate", nullptr, true },
    { "whorls", "Whorls", nullptr, true },
    { "two_rows", "Two rows", nullptr, true },
    { "horizontal", "Horizontal", nullptr, true },
} };
constexpr int kPatterns = static_cast<int>(kTo.size()) - 1;

// Option words, in the order of the enumeration Around.
constexpr std::array<tools::OptionWord, 2> kAround { {
    { "trunk", "Around the trunk" },
    { "branches", "Around branches" },
} };

void visit(tools::OptionVisitor& visitor, ArrangeTool& tool)
{
    visitor.choice({ kAround }, tool.around);
    visitor.choice({ kTo, tools::WordOption::Offered::InHand }, tool.to);
    visitor.number({ "whorl", "", kMinWhorl, kMaxWhorl, 1, "In a whorl" }, tool.whorl);
}

Result<std::vector<scene::Edit>> arrange(tools::Tool const& tool, Stroke const&,
                                         scene::Scene const& scene)
{
    auto const& options = *tool.get<ArrangeTool>();
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no outline: choose a tree that was "
                    "drawn by its outline, or draw one");
    silhouette::FormTree edit { scene.drawn->id, tree->form };
    bool const is_trunk = options.around == ArrangeTool::Around::Trunk;
    auto& pattern = edit.form.patterns[is_trunk ? 0 : 1];
    int const next = options.to == ArrangeTool::To::Next
        ? (static_cast<int>(pattern.kind) + 1) % kPatterns
        : static_cast<int>(options.to) - 1;
    pattern = static_cast<Pattern::Kind>(next);
    if (pattern == Pattern::Whorls)
        pattern = Pattern::whorls_of(static_cast<int>(std::lround(options.whorl)));
    if (!is_trunk)
        edit.form.patterns[2] = pattern;
    return std::vector<scene::Edit> { edit };
}

} // namespace

constexpr tools::ToolKind ArrangeTool::kKind {
    .word = "arrange",
    .label = "Arrange",
    .title = "Arrange the tree's branches",
    .done = "The branches stand in another pattern",
    .help = "stands the branches of a tree that was drawn by its outline, around its trunk or "
            "around its branches, in the next pattern or in one of these; whorls have so many "
            "branches",
    .group = "Sketch",
    .method = "From an outline",
    .begins_group_of_buttons = true,
    .at_once = true,
    .options = tools::options_type<ArrangeTool, visit>(),
    .edits_for = arrange,
    .other_end = { &EraseOutlineTool::kKind },
};

} // namespace tractus::silhouette
