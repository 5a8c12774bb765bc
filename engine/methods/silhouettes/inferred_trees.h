#pragma once

#include "engine/methods/silhouettes/kept_names.h"
#include "engine/methods/silhouettes/outlined_tree.h"

#include <list>
#include <memory>
#include <mutex>

namespace tractus::silhouette {

// Cache of the skeletons that were inferred for the newest versions of a tree. All versions of the
// tree share it, so that a changed line can be compared with the previous version without inferring
// it again. It affects speed only, never results. Thread-safe.
class InferredTrees {
public:
    // A cached inference, shared with readers.
    using Inferred = std::shared_ptr<InferredDrawing const>;

    // The entry for exactly this version of the tree; null if it is not cached.
    Inferred find(OutlinedTree const& tree);

    // Stores an entry. The newest two versions are kept, so that undo finds the previous one.
    void keep(OutlinedTree tree, Inferred inferred);

private:
    struct Version {
        OutlinedTree tree;
        Inferred inferred;
    };

    std::mutex mutex_; // Guards the members below.
    std::list<Version> newest_first_;
};

// The inferred skeleton of a tree, ignoring a declaration of the crown as a leaf. It comes from the
// cache or is computed and stored there. Fails like skeleton_of().
Result<InferredTrees::Inferred> inferred(OutlinedTree const& tree);

} // namespace tractus::silhouette
