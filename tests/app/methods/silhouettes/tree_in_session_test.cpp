#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/session/begin_empty.h"
#include "engine/methods/silhouettes/inferred_trees.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"
#include "tests/app/session/small_session.h"

#include <utility>
#include <vector>

namespace tractus::silhouette {
namespace {

using TreeInSession = session::SessionFolder;

// After a tree's crown is redrawn, and after that is undone, the inference of the tree must be
// known to the session, as it is to a scene in memory.
TEST_F(TreeInSession, IsKnownWhenItsLinesChange)
{
    using namespace drawn_trees;
    auto options = session::options_for_tests();
    options.kinds = methods::all_methods().edits;
    document::Document document(
        session::Session::create(path(), { .plant = "empty", .program = "1" },
                                 std::vector<scene::Edit> { session::BeginEmpty {} }, options)
            .value(),
        document::Document::Working::AtOnce);
    auto const is_known = [&] {
        auto const scene = document.newest()->scene;
        auto const& tree = *outlined_tree(*scene.drawn);
        return tree.inferred && tree.inferred->find(tree);
    };
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10), crown_around(1, 11) })
        document.draw({ stroke, OutlineTool {} });
    EXPECT_TRUE(is_known());
    document.undo();
    EXPECT_TRUE(is_known());
    document.draw({ crown_around(0, 9), OutlineTool {} });
    EXPECT_TRUE(is_known());
    EXPECT_EQ(document.newest()->scene.plants.size(), 1u);
}

} // namespace
} // namespace tractus::silhouette
