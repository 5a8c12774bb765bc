#include "app/methods/construction_lines/line_pattern_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/touched_sketch.h"
#include "engine/scene/write_rules.h"

#include <array>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

lines::Pattern with_other_sizes(lines::Pattern pattern)
{
    using enum lines::Pattern::Sizes;
    pattern.sizes = pattern.sizes == Linear ? HalfEllipses : Linear;
    return pattern;
}

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 4> kPatternChanges { {
    { "next", "Next pattern", nullptr, true },
    { "sizes", "Sizes around", nullptr, true },
    { "face", "Turn organs", nullptr, true },
    { "rules", "Back to the pattern", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, LinePatternTool& tool)
{
    visitor.choice({ kPatternChanges }, tool.what);
}

Result<std::vector<scene::Edit>> back_to_pattern(ActiveSketch const& active)
{
    if (!active.sketch.rules)
        return fail(Fault::User, "the rules are the pattern's: nobody has written others");
    return std::vector<scene::Edit> { scene::WriteRules { .plant = active.plant } };
}

Result<std::vector<scene::Edit>> set_next(tools::Tool const& tool, Stroke const&,
                                          scene::Scene const& scene)
{
    auto const active = TRY(active_sketch(scene));
    auto const& before = active.sketch.pattern;
    auto const what = tool.get<LinePatternTool>()->what;
    if (what == LinePatternTool::What::Rules)
        return back_to_pattern(active);
    auto const pattern = what == LinePatternTool::What::Next ? next_pattern(before)
        : what == LinePatternTool::What::Sizes               ? with_other_sizes(before)
                                                             : next_face(before);
    return std::vector<scene::Edit> { lines::SetLinePattern { active.plant, pattern } };
}

std::string describe_change(tools::Tool const& tool, scene::Scene const& scene)
{
    auto const* const sketch = lines::active_pen_sketch(scene.state);
    if (!sketch)
        return "";
    auto const what = tool.get<LinePatternTool>()->what;
    if (what == LinePatternTool::What::Next)
        return fmt::format("The organs are {} now", lines::name_of(sketch->pattern.kind));
    if (what == LinePatternTool::What::Face)
        return fmt::format("The organs {} now", describe_face(sketch->pattern));
    if (what == LinePatternTool::What::Rules)
        return "The rules are the pattern's again";
    return sketch->pattern.sizes == lines::Pattern::Sizes::Linear
        ? "Sizes change evenly around the stem now, but between boundaries in space"
        : "Sizes follow half-ellipses around the stem now";
}

} // namespace

lines::Pattern next_pattern(lines::Pattern pattern)
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

lines::Pattern next_face(lines::Pattern pattern)
{
    using enum lines::Pattern::Face;
    double const roll_deg = lines::roll_deg(pattern);
    pattern.face = roll_deg < 0 ? Down : roll_deg > 0 ? Flat : Up;
    return pattern;
}

std::string describe_face(lines::Pattern const& pattern)
{
    double const roll_deg = lines::roll_deg(pattern);
    if (roll_deg == 0)
        return "lie flat";
    return roll_deg < 0 ? "turn their upper side up" : "turn their upper side down";
}

constexpr tools::ToolKind LinePatternTool::kKind {
    .word = "line_pattern",
    .label = "Next pattern",
    .title = "The next pattern",
    .done = "The organs have another pattern",
    .help = "gives the organs of the sketch that takes what is drawn the next pattern: "
            "distichous, decussate, spiral, alternate, whorled; lets their sizes follow "
            "half-ellipses around the stem, or change evenly again; turns them to lie flat, with "
            "their upper side up, or down; or takes the pattern's rules again in place of those "
            "that somebody has written",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .at_once = true,
    .options = tools::options_type<LinePatternTool, visit>(),
    .edits_for = set_next,
    .describe = describe_change,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
