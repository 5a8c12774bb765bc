#include "engine/methods/silhouettes/inferred_trees.h"

#include <algorithm>
#include <utility>

namespace tractus::silhouette {

InferredTrees::Inferred InferredTrees::find(OutlinedTree const& tree)
{
    std::lock_guard const lock(mutex_);
    auto const found
        = std::find_if(newest_first_.begin(), newest_first_.end(), [&](Version const& version) {
              return OutlinedTree::kKind.same(&version.tree, &tree);
          });
    if (found == newest_first_.end())
        return nullptr;
    newest_first_.splice(newest_first_.begin(), newest_first_, found);
    return found->inferred;
}

void InferredTrees::keep(OutlinedTree tree, Inferred inferred)
{
    constexpr std::size_t kMax = 2;
    tree.inferred.reset(); // Avoids a reference cycle: the tree's cache would keep itself alive.
    std::lock_guard const lock(mutex_);
    newest_first_.push_front({ std::move(tree), std::move(inferred) });
    if (newest_first_.size() > kMax)
        newest_first_.pop_back();
}

Result<InferredTrees::Inferred> inferred(OutlinedTree const& tree)
{
    if (auto known = tree.inferred ? tree.inferred->find(tree) : nullptr)
        return known;
    auto drawing = TRY(drawing_of(tree));
    bool const is_leaf = std::exchange(drawing.is_leaf, false);
    auto made
        = std::make_shared<InferredDrawing const>(TRY(infer_drawing(drawing, options_of(tree))));
    if (tree.inferred && !is_leaf)
        tree.inferred->keep(tree, made);
    return made;
}

} // namespace tractus::silhouette
