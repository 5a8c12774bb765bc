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

// Grows the leaves that `order` requests, no two alike, and paints them on one page of square cells
// of 256 pixels. The petiole's end is at the bottom centre of each cell. The output does not depend
// on the number of threads. Fails with a user error if the grammar produces no leaf.
Result<lsystem::LeafSheet> grow_leaf_sheet(leaf::Grammar const& grammar,
                                           lsystem::LeafOrder const& order);

// Text of the leaf sheet that a name requests (leaf_sheet.h), from a grammar in `folder` if the
// name contains a .leaf file, otherwise from a built-in grammar. No value if the name is not a leaf
// sheet's. Fails with a user error like grow_leaf_sheet() and load_leaf_grammar().
Result<std::optional<std::string>> make_ordered_leaves(std::filesystem::path const& folder,
                                                       std::string const& name);

// Cuts a cut-out (in pixels) along the vertical line through the petiole's end at `stem`, and
// `bends` times across that line so that it can bend. The blade is `blade_px` long. The leaf's
// place in the picture is not set. Empty unless the vertical line crosses the cut-out's outline
// exactly twice.
CutLeaf cut_along_midrib(leaf::Cutout const& cutout, Vec2 const& stem, double blade_px, int bends);

} // namespace tractus::leaf
