#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/outline.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::silhouette {

// A tree's drawing as read from a file.
struct SilhouetteFile {
    Drawing drawing;
    // Outlines around branches, and branches that begin on other branches.
    std::vector<std::vector<Vec2>> parts {};
    // Touches on bumps of the crown and of the parts (bump_touch.h): all splits, then all joins.
    std::vector<BumpTouch> touches {};
    // Outlines of branches that are leaves. A single point instead of an outline marks a bump that
    // is a leaf (bump_leaf.h).
    std::vector<std::vector<Vec2>> leaves {};
    // Lines that copy a style: each from one branch across others, which take that branch's style
    // (chosen_style.h).
    std::vector<std::vector<Vec2>> styles {};
    // Lines in space on the crown's surface (drawn_surface.h): rings, then climbing lines, then
    // outlines in vertical planes.
    std::vector<CrownLine> crown_lines {};
    std::vector<std::string> unknown_keys; // Keys of the file that were not understood.
};

// Reads a drawing from JSON. Lengths are in millimetres, x to the right and y up. All keys except
// outline are optional:
//
//   outline   [[x, y], …]: around the crown, or [[[x, y], …], …]: in several strokes
//   trunk     [[x, y], …]: base first
//   branches  [[[x, y], …], …]: starting at the trunk
//   parts     [[[x, y], …], …]: each a closed line around the crown of a branch, or an open line:
//             a branch that starts on its parent branch
//   leaves    [[[x, y], …], …]: closed lines around leaves. A single point [[x, y]] on a bump means
//             that the branch that ends in this bump is a leaf. Without an outline, the first leaf
//             is the crown
//   splits    [[x, y], …]: each on a bump of an outline
//   joins     [[x, y], …]: each between two bumps
//   styles    [[[x, y], …], …]: each a line from a branch across others, which take its style
//   rings     [{"height": y, "ring": [[x, z], …]}, …]: around the crown, z behind the sheet
//   climbs    [[[x, y, z], …], …]: each winds around the crown more than once while climbing
//   sides     [{"azimuth": degrees, "outline": [[x, y], …]}, …]: outlines in vertical planes that
//             are turned about the vertical through the trunk's base; at 90 degrees, x points
//             behind the sheet. With rings, climbs or sides, the outline may be missing
//
// Fails with a user error that names the file, the place and what to write.
Result<SilhouetteFile> parse_silhouette(std::string_view text, std::string const& name);

// Reads a drawing from a file of at most 2 MiB: JSON as for parse_silhouette(), or an SVG drawing
// (.svg). The role of an SVG line is the beginning of its id, class or label, or of those of a
// group around the line: "trunk", "outline", "branch", "part", "leaf", "split", "join" or "style".
// Splits and joins are at the midpoint of their line. If no line has a role, the straightest line
// is the trunk, provided that its ends are farther apart than half its length; all other lines are
// the outline.
Result<SilhouetteFile> load_silhouette(std::filesystem::path const& path);

} // namespace tractus::silhouette
