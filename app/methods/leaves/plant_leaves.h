#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/methods/leaves/leaf_cutout.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::leaf {

// Maximum number of triangles of a leaf on a plant.
constexpr std::size_t kMaxLeafTriangles = 24;

// Grows the leaves that `order` requests, each of which is different, and paints them on one page
// of square cells of 256 pixels. The petiole's end is at the bottom centre of each cell. The output
// does not depend on the number of threads. Fails with a user error if the grammar produces no
// leaf.
Result<lsystem::LeafSheet> grow_leaf_sheet(leaf::Grammar const& grammar,
                                           lsystem::LeafOrder const& order);

// Returns the text of the leaf sheet that the name `name` requests (leaf_sheet.h). The leaves are
// grown from a grammar in `folder` if the name contains a .leaf file, otherwise from a built-in
// grammar. Returns no value if the name does not request a leaf sheet. Fails with a user error if
// the grammar cannot be loaded or produces no leaf.
Result<std::optional<std::string>> make_ordered_leaves(std::filesystem::path const& folder,
                                                       std::string const& name);

// Cuts the outline of a leaf's picture along the vertical line through the petiole's end, and the
// halves at `bends` points of that line, so that the blade can bend there. `stem` is the petiole's
// end and `blade_px` the length of the blade, in pixels. The leaf's place in the picture is not
// set. Empty unless the vertical line crosses the outline exactly twice.
CutLeaf cut_along_midrib(leaf::Cutout const& cutout, Vec2 const& stem, double blade_px, int bends);

} // namespace tractus::leaf
