#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/outline.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::silhouette {

// A drawing as a file holds it.
struct SilhouetteFile {
    Drawing drawing;
    // Outlines of branches, around which they lie, and branches on branches, on which they begin.
    std::vector<std::vector<Vec2>> parts {};
    // Touches on the bumps of the crown and of parts (bump_touch.h): splits, then joins.
    std::vector<BumpTouch> touches {};
    // Outlines of branches that are leaves; of one point: it is on a bump that is one
    // (bump_leaf.h).
    std::vector<std::vector<Vec2>> leaves {};
    // Lines from a branch over others, to which its style goes (chosen_style.h).
    std::vector<std::vector<Vec2>> styles {};
    // Lines in space on the crown's surface (drawn_surface.h): rings, then lines that climb, then
    // outlines in upright planes.
    std::vector<CrownLine> crown_lines {};
    std::vector<std::string> unknown_keys; // What else the file says.
};

// Reads a drawing from JSON, millimetres, x to the right and y up:
//
//   outline   [[x, y], …]: around the crown, or [[[x, y], …], …]: in several strokes
//   trunk     [[x, y], …]: base first; may be missing
//   branches  [[[x, y], …], …]: from the trunk on; may be missing
//   parts     [[[x, y], …], …]: each once around a branch's own crown, or from a branch on, of
//             which it is a branch; may be missing
//   leaves    [[[x, y], …], …]: parts that are leaves, [[x, y]] the part of a branch that ends in
//             the bump there; may be missing. Without an outline the first one is the crown's
//   splits    [[x, y], …]: each on a bump of an outline; may be missing
//   joins     [[x, y], …]: each between two bumps; may be missing
//   styles    [[[x, y], …], …]: each from a branch over others; may be missing
//   rings     [{"height": y, "ring": [[x, z], …]}, …]: around the crown, z behind the sheet
//   climbs    [[[x, y, z], …], …]: each around the crown more than once while it climbs
//   sides     [{"azimuth": degrees, "outline": [[x, y], …]}, …]: outlines in upright planes through
//             the trunk's foot, which are turned about it: at 90 x is behind the sheet. With any of
//             these three there need be no outline
//
// Fails, as the user's fault, with file, place and what to write.
Result<SilhouetteFile> parse_silhouette(std::string_view text, std::string const& name);

// The same from a file of at most 2 MiB, which may also be an SVG drawing (.svg): lines whose id,
// class or label, or that of a group around them, begins with "trunk", "outline", "branch",
// "part", "leaf", "split", "join" or "style"; of a split and a join the line's middle counts. Where
// none does, the straightest is the trunk, if its ends are farther apart
// than half of its length, and the others are the outline.
Result<SilhouetteFile> load_silhouette(std::filesystem::path const& path);

} // namespace tractus::silhouette
