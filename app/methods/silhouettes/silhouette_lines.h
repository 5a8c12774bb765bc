#pragma once

#include "app/methods/silhouettes/silhouette_file.h"
#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <vector>

namespace tractus::silhouette {

// What follows from a file's lines, one after the other as by a pen: the crown, its surface and its
// branches, touches on the crown's bumps, parts, leaves, touches inside of parts, styles. Says in
// the drawing of which branches they are. `style_to`: of branches with parts or leaves. Fails, as
// the user's fault, with which line it is.
Result<Skeleton> infer_lines(SilhouetteFile& file, SkeletonOptions options, StyleTo style_to);

// The edits of a pen that draws the lines. `first` has what all have: the tree's form and scale.
// Fails, as the user's fault, for an outline of several strokes, and like infer_lines().
Result<std::vector<scene::Edit>> edits_of_lines(SilhouetteFile const& file, DrawTree const& first,
                                                StyleTo style_to);

} // namespace tractus::silhouette
