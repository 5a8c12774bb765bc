#include "engine/methods/leaves/derived_outline.h"

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/print_grammar.h"

namespace tractus::leaf {

namespace {

// The border begins at the first face, the stalk, whose first edge is free.
constexpr Dart kStart = 0;

Result<void> derive_whole(Leaf& leaf, int steps)
{
    while (leaf.step() < steps)
        TRY(leaf.derive());
    return leaf.fill();
}

} // namespace

Result<FlatLine> derived_outline(DrawnLeaf const& drawn)
{
    auto const grammar = TRY(parse_grammar(print_grammar(drawn, "drawn"), "drawn.leaf"));
    auto leaf = TRY(Leaf::begin(grammar, { .final_step = grammar.steps, .variation = 0 }));
    TRY(derive_whole(leaf, grammar.steps));
    auto const& map = leaf.map();
    FlatLine line;
    for (auto const d : map.border(kStart))
        if (map.face(d) != 0)
            line.push_back(map.flat_of(d) - Vec2(0, drawn.stalk));
    return line;
}

Result<std::vector<FlatLine>> derived_leaflets(DrawnLeaf const& drawn)
{
    auto const grammar = TRY(parse_grammar(print_grammar(drawn, "drawn"), "drawn.leaf"));
    auto leaf = TRY(Leaf::begin(grammar, { .final_step = grammar.steps, .variation = 0 }));
    TRY(derive_whole(leaf, grammar.steps));
    auto const& map = leaf.map();
    // Between two leaflets the border runs along stalks and the rachis.
    std::vector<FlatLine> leaflets(1);
    for (auto const d : map.border(kStart))
        if (!leaf.is_bare(map.face(d)))
            leaflets.back().push_back(map.flat_of(d));
        else if (!leaflets.back().empty())
            leaflets.emplace_back();
    if (leaflets.back().empty())
        leaflets.pop_back();
    return leaflets;
}

} // namespace tractus::leaf
