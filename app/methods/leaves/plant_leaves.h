#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/methods/leaves/leaf_cutout.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::leaf {

// Leaves for plants have at most that many triangles.
constexpr std::size_t kMostLeafTriangles = 24;

// Grows the leaves of an order, no two alike, and paints them on one page of square cells of 256
// pixels. The stalk's end is below, in the middle of each. Any number of threads gives the same
// bytes. Fails, as the user's fault, where the grammar gives no leaf.
Result<lsystem::LeafSheet> grow_leaf_sheet(leaf::Grammar const& grammar,
                                           lsystem::LeafOrder const& order);

// The text of the sheet that a name orders (leaf_sheet.h), from a grammar in `folder` if the order
// names a .leaf, and else from one of ours. No value where the name orders none. Fails, as the
// user's fault, like grow_leaf_sheet() and load_leaf_grammar().
Result<std::optional<std::string>> make_ordered_leaves(std::filesystem::path const& folder,
                                                       std::string const& name);

// A cut-out in pixels as a leaf whose blade is `blade_px` long, cut along the line that goes up
// from the stalk's end at `stem`, and `bends` times across that line where it can bend. Its place
// in the picture is left open. Empty where the line leaves the cut-out in between.
CutLeaf cut_along_midrib(leaf::Cutout const& cutout, Vec2 const& stem, double blade_px, int bends);

} // namespace tractus::leaf
