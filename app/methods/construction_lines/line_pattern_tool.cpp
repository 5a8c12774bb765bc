#include "app/methods/construction_lines/line_pattern_tool.h"

#include "app/methods/construction_lines/touched_sketch.h"
#include "app/tools/erase_tool.h"

#include <fmt/format.h>

namespace tractus {

namespace {

// Patterns that bear organs follow each other in a ring.
lines::Pattern after(lines::Pattern pattern)
{
    using enum lines::Pattern::Kind;
    switch (pattern.kind) {
    case Distichous:
        pattern.kind = Decussate;
        return pattern;
    case Decussate:
        pattern.kind = Spiral;
        pattern.divergence_deg = lines::Pattern().divergence_deg;
        return pattern;
    case Spiral:
        pattern.kind = Alternate;
        pattern.divergence_deg = 180;
        return pattern;
    case Alternate:
        pattern.kind = Whorled;
        return pattern;
    case Whorled:
    case Bare:
        break;
    }
    pattern.kind = Distichous;
    return pattern;
}

Result<std::vector<Edit>> set_next(Tool const&, Stroke const&, Scene const& scene)
{
    auto const active = TRY(active_sketch(scene));
    return std::vector<Edit> { lines::SetLinePattern { active.plant,
                                                       after(active.sketch.pattern) } };
}

std::string said(Tool const&, Scene const& scene)
{
    auto const* const sketch = lines::active_pen_sketch(scene.state);
    return sketch ? fmt::format("The organs are {} now", lines::name_of(sketch->pattern.kind)) : "";
}

} // namespace

constexpr ToolKind LinePatternTool::kKind {
    .word = "line_pattern",
    .label = "Next pattern",
    .title = "The next pattern",
    .done = "The organs have another pattern",
    .help = "gives the organs of the sketch that takes what is drawn the next pattern: "
            "distichous, decussate, spiral, alternate, whorled",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .at_once = true,
    .options = options_type<LinePatternTool>(),
    .mean = set_next,
    .said = said,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus
