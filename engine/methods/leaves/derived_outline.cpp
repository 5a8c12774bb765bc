#include "engine/methods/leaves/derived_outline.h"

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/print_grammar.h"

namespace tractus::leaf {

Result<FlatLine> derived_outline(DrawnLeaf const& drawn)
{
    auto const grammar = TRY(parse_grammar(print_grammar(drawn, "drawn"), "drawn.leaf"));
    auto leaf = TRY(Leaf::begin(grammar, { .final_step = grammar.steps, .variation = 0 }));
    while (leaf.step() < grammar.steps)
        TRY(leaf.derive());
    TRY(leaf.fill());
    auto const& map = leaf.map();
    Dart start = 0; // The border begins at the first face, the stalk, whose first edge is free.
    FlatLine line;
    for (auto const d : map.border(start))
        if (map.face(d) != 0)
            line.push_back(map.flat_of(d) - Vec2(0, drawn.stalk));
    return line;
}

} // namespace tractus::leaf
