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
    // Outlines around branches, and branches that begin on branches.
    std::vector<std::vector<Vec2>> parts {};
    // Touches on bumps of the crown and of parts (bump_touch.h): splits first, then joins.
    std::vector<BumpTouch> touches {};
    // Outlines of branches that are leaves; a single point marks a bump that is a leaf
    // (bump_leaf.h).
    std::vector<std::vector<Vec2>> leaves {};
    // Lines from one branch across others that take its style (chosen_style.h).
    std::vector<std::vector<Vec2>> styles {};
    // Lines in space on the crown's surface (drawn_surface.h): rings, then climbing lines, then
    // outlines in vertical planes.
    std::vector<CrownLine> crown_lines {};
    std::vector<std::string> unknown_keys; // Keys of the file that were not understood.
};

// Reads a drawing from JSON, in millimetres, x to the right and y up; all keys but outline are
// optional:
//
//   outline   [[x, y], …]: around the crown, or [[[x, y], …], …]: in several strokes
//   trunk     [[x, y], …]: base first
//   branches  [[[x, y], …], …]: starting at the trunk
//   parts     [[[x, y], …], …]: each a closed line around a branch's own crown, or a branch that
//             starts at the branch that bears it
//   leaves    [[[x, y], …], …]: parts that are leaves. A single point [[x, y]] stands for the part
//             of the branch that ends in the bump there. Without an outline the first leaf is the
//             crown
//   splits    [[x, y], …]: each on a bump of an outline
//   joins     [[x, y], …]: each between two bumps
//   styles    [[[x, y], …], …]: each from one branch across others
//   rings     [{"height": y, "ring": [[x, z], …]}, …]: around the crown, z behind the sheet
//   climbs    [[[x, y, z], …], …]: each winds around the crown more than once while climbing
//   sides     [{"azimuth": degrees, "outline": [[x, y], …]}, …]: outlines in vertical planes
//             through the trunk's base, turned about it: at 90 degrees x points behind the sheet.
//             With rings, climbs or sides the outline may be missing
//
// Fails with a user error that names the file, the place and what to write.
Result<SilhouetteFile> parse_silhouette(std::string_view text, std::string const& name);

// Reads a drawing from a file of at most 2 MiB: JSON as for parse_silhouette(), or an SVG drawing
// (.svg). An SVG line's role is the beginning of its id, class or label, or of those of a group
// around it: "trunk", "outline", "branch", "part", "leaf", "split", "join" or "style"; splits and
// joins are at the line's midpoint. If no line has such a name, the straightest one is the trunk,
// provided that its ends are farther apart than half its length, and the others are the outline.
Result<SilhouetteFile> load_silhouette(std::filesystem::path const& path);

} // namespace tractus::silhouette
