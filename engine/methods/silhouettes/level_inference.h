#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/branch_style.h"
#include "engine/methods/silhouettes/branching_system.h"

#include <vector>

namespace tractus::silhouette {

// Which branches of a level bear others.
enum class Which { All, Refined };

// How the crowns of one level are looked into.
struct LevelInference {
    InferenceOptions usual;
    InferenceOptions outlined;
    Which which = Which::All;
    // Whether branches that somebody drew on bear others than those.
    enum class Besides { Nothing, Inferred } besides = Besides::Inferred;
};

// Infers the branches of the trunk, or nothing in a crown that is a leaf. Fails like
// infer_system().
Result<BranchingSystem> system_of_crown(Drawing const& drawing, InferenceOptions const& options);

// Infers what a branch bears, with what was drawn on it, as that was drawn. Fails like
// infer_system().
Result<BranchingSystem> system_below(Branch const& branch, LevelInference const& how);

// The options with the angles of a level's style, if it has one.
InferenceOptions styled(InferenceOptions options, std::vector<BranchStyle> const& styles,
                        int level);

} // namespace tractus::silhouette
