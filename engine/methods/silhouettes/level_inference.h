#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/branching_system.h"

#include <vector>

namespace tractus::silhouette {

// The branches of a level that get children: all, or only those on which something was drawn.
enum class Which { All, Refined };

// Options for inferring the crowns of one level.
struct LevelInference {
    InferenceOptions usual;
    InferenceOptions outlined;
    Which which = Which::All;
    // Inferred children of branches that have drawn children: none, or in addition to the drawn
    // ones.
    enum class Besides { Nothing, Inferred } besides = Besides::Inferred;
};

// Infers the branches of the trunk; none if the crown is declared a leaf. Fails like
// infer_system().
Result<BranchingSystem> infer_crown_system(Drawing const& drawing, InferenceOptions const& options);

// Infers the children of a branch; everything that was drawn on the branch stays unchanged. Fails
// like infer_system().
Result<BranchingSystem> system_below(Branch const& branch, LevelInference const& how);

// Returns `options` with the branching angles of the level's style, if that level has a style.
InferenceOptions styled(InferenceOptions options, std::vector<BranchStyle> const& styles,
                        int level);

} // namespace tractus::silhouette
