#pragma once

#include "engine/methods/silhouettes/kept_names.h"
#include "engine/methods/silhouettes/outlined_tree.h"

#include <list>
#include <memory>
#include <mutex>

namespace tractus::silhouette {

// What was inferred of the newest versions of a tree, which share it: so a line that is drawn anew
// is compared with the tree as it was, and then built, without inferring either again. Only how
// long things take depends on what is in here. Any thread may call.
class InferredTrees {
public:
    using Inferred = std::shared_ptr<InferredDrawing const>; // Shared with who looks at it.

    // Of this very version; null: it is not known, or not any more.
    Inferred find(OutlinedTree const& tree);

    // Keeps the newest two versions, so that undo finds the one before, too.
    void keep(OutlinedTree tree, Inferred inferred);

private:
    struct Version {
        OutlinedTree tree;
        Inferred inferred;
    };

    std::mutex mutex_; // Guards what follows.
    std::list<Version> newest_first_;
};

// The tree as it would be if its crown were no leaf: known, or inferred and kept for later. Fails
// like skeleton_of().
Result<InferredTrees::Inferred> inferred(OutlinedTree const& tree);

} // namespace tractus::silhouette
