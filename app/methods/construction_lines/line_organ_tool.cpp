#include "app/methods/construction_lines/line_organ_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/line_previewer.h"
#include "app/methods/construction_lines/touched_sketch.h"
#include "app/methods/construction_lines/traced_picture.h"
#include "engine/methods/construction_lines/organ_edits.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace tractus::lines {

namespace {

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 4> kOrganWords { {
    { "edge", "Leaf's edge" },
    { "midrib", "Its midrib" },
    { "section", "Its section" },
    { "another_leaf", "Another leaf" },
} };

// Option words, in the order of lines::OrganColor.
constexpr std::array<tools::OptionWord, 8> kColorWords { {
    { "green", "green" },
    { "white", "white" },
    { "yellow", "yellow" },
    { "pink", "pink" },
    { "violet", "violet" },
    { "red", "red" },
    { "brown", "brown" },
    { "from_picture", "as the picture" },
} };

void visit(tools::OptionVisitor& visitor, LineOrganTool& tool)
{
    visitor.choice({ kOrganWords, tools::WordOption::Offered::InHand }, tool.what);
    visitor.choice(
        { .words = kColorWords, .offered = tools::WordOption::Offered::InTurn, .label = "Colour" },
        tool.color);
}

// The leaf to which new lines belong: the newest leaf drawn in the sketch; 0 if there is none.
scene::ItemId leaf_in_hand(lines::PenSketch const& sketch)
{
    auto const found = std::find_if(sketch.organs.rbegin(), sketch.organs.rend(),
                                    [](lines::SketchOrgan const& organ) { return !organ.sketch; });
    return found == sketch.organs.rend() ? 0 : found->id;
}

lines::OrganView organ_view(LineOrganTool::What what)
{
    using Line = LineOrganTool::What;
    switch (what) {
    case Line::Midrib:
        return lines::OrganView::Midrib;
    case Line::Section:
        return lines::OrganView::Section;
    case Line::Edge:
    case Line::Another:
        break;
    }
    return lines::OrganView::Side;
}

// The texture of a leaf after `line` was added, cut from the image behind the leaf. No value if the
// leaf keeps its present texture. Fails with a user error if there is no image behind the leaf and
// the leaf has no texture yet.
Result<std::optional<std::string>> picture_with(SketchOrgan organ, SketchOrgan::Line line,
                                                scene::Scene const& scene)
{
    auto const sheet = line.line.sheet;
    bool const is_outline = line.view == lines::OrganView::Side;
    bool const is_painted = organ.picture != nullptr;
    if (is_painted && !is_outline)
        return std::nullopt;
    auto const drawn = TRY(with_organ_line(std::move(organ), std::move(line)));
    auto picture = scene.state.picture ? traced_picture(drawn, sheet, *scene.state.picture)
                                       : fail(Fault::User,
                                              "no picture lies behind the leaf: lay one there, or "
                                              "choose a colour");
    if (!picture && is_painted)
        return std::nullopt;
    return TRY(std::move(picture));
}

Result<std::vector<scene::Edit>> draw_organ(tools::Tool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene)
{
    auto const& options = *tool.get<LineOrganTool>();
    auto const active = TRY(active_sketch(scene));
    bool const is_another = options.what == LineOrganTool::What::Another;
    lines::DrawOrgan const draw { .plant = active.plant,
                                  .organ = is_another ? 0 : leaf_in_hand(active.sketch),
                                  .view = organ_view(options.what),
                                  .color = options.color,
                                  .stroke = stroke };
    std::vector<scene::Edit> edits { draw };
    if (options.color != lines::OrganColor::Picture)
        return edits;
    auto const number = organ_number(active.sketch, draw.organ);
    auto picture
        = TRY(picture_with(number > 0 ? active.sketch.organs[number - 1] : SketchOrgan {},
                           { draw.view, { .stroke = stroke, .sheet = active.sheet } }, scene));
    if (picture)
        edits.emplace_back(lines::PaintOrgan {
            .plant = active.plant, .organ = draw.organ, .picture = *std::move(picture) });
    return edits;
}

std::string describe_leaf(tools::Tool const& tool, scene::Scene const& after)
{
    auto const* const sketch = lines::active_pen_sketch(after.state);
    if (!sketch)
        return "";
    if (tool.get<LineOrganTool>()->what == LineOrganTool::What::Another)
        return "The topmost layer bears this leaf: Layer's organ gives it to others";
    if (sketch->organs.empty() || sketch->organs.back().sketch)
        return "";
    auto const& lines = sketch->organs.back().lines;
    auto const has = [&](lines::OrganView view) {
        return std::any_of(lines.begin(), lines.end(),
                           [&](lines::SketchOrgan::Line const& line) { return line.view == view; });
    };
    if (!has(lines::OrganView::Midrib))
        return "The leaf is flat: draw its midrib, as seen from its side, to let it arch";
    if (!has(lines::OrganView::Section))
        return "Draw its section, as seen from its tip, to fold it";
    return "The leaves follow the line";
}

} // namespace

constexpr tools::ToolKind LineOrganTool::kKind {
    .word = "line_organ",
    .label = "Leaf's edge",
    .title = "Draw a leaf in three views",
    .done = "The leaves follow the line",
    .help = "draws the leaves of a sketch's plant in three views: an edge from base to tip as seen "
            "from above, whose other side is its mirror image until it is drawn; the midrib as "
            "seen from the side; and the section as seen from the tip. another_leaf begins "
            "another kind of leaf, which the topmost layer bears. from_picture takes the leaf's "
            "picture from the one that lies behind it",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .surface = tools::Surface::Paper,
    .min_extent_mm = 2,
    .options = tools::options_type<LineOrganTool, visit>(),
    .edits_for = draw_organ,
    .describe = describe_leaf,
    .previewer = line_previewer,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
