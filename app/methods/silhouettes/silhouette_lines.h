#pragma once

#include "app/methods/silhouettes/silhouette_file.h"
#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <vector>

namespace tractus::silhouette {

// Infers a skeleton from a file's lines as if a pen drew them in this order: the crown, its surface
// and branches, touches on the crown's bumps, parts, leaves, touches inside parts, styles. Sets in
// `file` which branches the lines belong to. `style_to` says which branches take the style of a
// branch with parts or leaves. Fails with a user error that names the line.
Result<Skeleton> infer_lines(SilhouetteFile& file, SkeletonOptions options, StyleScope style_to);

// The edits that a pen would make by drawing the file's lines. `first` holds the tree's form and
// scale. Fails with a user error for an outline of several strokes, and like infer_lines().
Result<std::vector<scene::Edit>> edits_of_lines(SilhouetteFile const& file, DrawTree const& first,
                                                StyleScope style_to);

} // namespace tractus::silhouette
