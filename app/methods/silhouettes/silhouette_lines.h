#pragma once

#include "app/methods/silhouettes/silhouette_file.h"
#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <vector>

namespace tractus::silhouette {

// Infers a skeleton from the lines of a file as if a pen drew them in this order: the crown, its
// surface and branches, touches on the crown's bumps, parts, leaves, touches inside parts, styles.
// Stores in `file` to which branches the lines belong. `style_to` says which other branches take
// the style of a branch with parts or leaves. Fails with a user error that names the line.
Result<Skeleton> infer_lines(SilhouetteFile& file, SkeletonOptions options, StyleScope style_to);

// The edits that a pen would make by drawing the lines of a file. `first` has the tree's form and
// scale. Fails with a user error if a line is invalid or the outline has several strokes.
Result<std::vector<scene::Edit>> edits_of_lines(SilhouetteFile const& file, DrawTree const& first,
                                                StyleScope style_to);

} // namespace tractus::silhouette
