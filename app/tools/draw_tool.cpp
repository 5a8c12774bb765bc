#include "app/tools/draw_tool.h"

#include "app/tools/branch_previewer.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <array>
#include <utility>

namespace tractus::tools {

namespace {

// Option words, in the order of the enumeration Propagation.
constexpr std::array<OptionWord, 3> kPropagationWords { {
    { "selected", "Selected", "Draw: the branch" },
    { "descendants", "All it bears", "Draw: all that the branch bears" },
    { "both", "Both", "Draw: the branch and all that it bears" },
} };

// Option words, in the order of the enumeration StrokeFit.
constexpr std::array<OptionWord, 3> kFitWords { {
    { "start", "From its base" },
    { "chord", "Base to tip" },
    { "world", "As it lies" },
} };

// Option words, in the order of the enumeration StrokeLaying. Logs that are older than "heading"
// lack the option and mean "least_twist".
constexpr std::array<OptionWord, 2> kLayingWords { {
    { "least_twist", "Least twist" },
    { "heading", "By heading" },
} };

void visit(OptionVisitor& visitor, DrawTool& tool)
{
    visitor.choice({ kPropagationWords }, tool.propagation);
    visit_laying(visitor, WordOption::Offered::InHand, tool.fit, tool.laying);
    visit_base(visitor, tool.base);
}

Result<std::vector<scene::Edit>> draw_selected(Tool const& tool, Stroke const& stroke,
                                               scene::Scene const& scene)
{
    auto const& options = *tool.get<DrawTool>();
    if (scene.selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    // What a branch bears has feet elsewhere, so only a stroke for the branch itself is reversed.
    auto const base = options.propagation == variation::Propagation::Descendants
        ? StrokeBase::AsDrawn
        : options.base;
    auto [drawn, is_reversed] = from_foot(base, stroke, scene.selection.front(), scene);
    return std::vector<scene::Edit> { scene::Associate { .stroke = std::move(drawn),
                                                         .propagation = options.propagation,
                                                         .fit = options.fit,
                                                         .laying = options.laying,
                                                         .is_drawn_reversed = is_reversed } };
}

} // namespace

void visit_laying(OptionVisitor& visitor, WordOption::Offered offered, variation::StrokeFit& fit,
                  variation::StrokeLaying& laying)
{
    visitor.choice({ kFitWords, offered }, fit);
    visitor.choice({ kLayingWords, WordOption::Offered::Never }, laying);
}

constexpr ToolKind DrawTool::kKind {
    .word = "draw",
    .label = "Draw",
    .title = "Draw",
    .done = "The stroke shapes the branch",
    .help = "shapes the selected branch, all that it bears, or both; the stroke is turned to each "
            "branch's heading and pitched so that it starts as the branch did, or leads from its "
            "first point to its last as the branch did, or is not turned at all; a trunk takes it "
            "as it was drawn; one that runs from the branch's tip to its foot is turned round",
    .group = "Draw",
    .min_extent_mm = 6,
    .options = options_type<DrawTool, visit>(),
    .edits_for = draw_selected,
    .describe = bent_branch_message,
    .previewer = branch_previewer,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
