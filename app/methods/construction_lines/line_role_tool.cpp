#include "app/methods/construction_lines/line_role_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/touched_sketch.h"

#include <algorithm>
#include <array>

namespace tractus::lines {

namespace {

using enum lines::Role;

constexpr std::array<tools::OptionWord, 9> kRoleWords { {
    { "inclination", "It is an inclination" },
    { "half", "Half of one" },
    { "left", "Left" },
    { "right", "Right" },
    { "around", "Around" },
    { "stem", "Stem" },
    { "none", "No line" },
    { "closed_outline", "Outline" },
    { "turned", "Turn round" },
} };
constexpr std::array kRoles { Inclination, HalfInclination, Left,   Right, Around,
                              Stem,        Unsure,          Outline };
// Index of the word that reverses a line; it follows the words for roles.
constexpr int kTurned = 8;
static_assert(kRoles.size() == kTurned && kRoleWords.size() == kTurned + 1);

void visit(tools::OptionVisitor& visitor, LineRoleTool& tool)
{
    auto const* const found = std::find(kRoles.begin(), kRoles.end(), tool.role);
    int number = tool.turn_round ? kTurned : static_cast<int>(found - kRoles.begin());
    visitor.word({ kRoleWords, tools::WordOption::Offered::InHand }, number);
    tool.turn_round = number == kTurned;
    tool.role = tool.turn_round ? LineRoleTool().role : kRoles[static_cast<std::size_t>(number)];
}

Result<std::vector<scene::Edit>> set_role(tools::Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    auto const active = TRY(active_sketch(scene));
    auto const line = lines::line_at(active.sketch, touched_mm(active, stroke));
    if (!line)
        return fail(Fault::User, "there is no construction line here: touch one of the sketch");
    auto const& options = *tool.get<LineRoleTool>();
    if (options.turn_round)
        return std::vector<scene::Edit> { lines::TurnLine { active.plant, *line } };
    return std::vector<scene::Edit> { lines::SetLineRole { active.plant, *line, options.role } };
}

} // namespace

constexpr tools::ToolKind LineRoleTool::kKind {
    .word = "line_role",
    .label = "What a line is",
    .title = "Say what a line is",
    .done = "The line is what you say",
    .help
    = "says what the line of a sketch under the stroke's end is, or turns it round: of a stem top "
      "and foot are exchanged",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .surface = tools::Surface::Paper,
    .options = tools::options_type<LineRoleTool, visit>(),
    .edits_for = set_role,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
