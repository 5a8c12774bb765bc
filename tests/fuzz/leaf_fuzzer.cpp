// Fuzzes leaf grammars, and the leaf that a grammar grows in a few steps.

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"
#include "tests/fuzz/fuzz_input.h"

#include <algorithm>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput const input(data, size);
    auto const grammar = leaf::parse_grammar(input.text(), "fuzz");
    if (!is_read(grammar))
        return 0;
    int const steps = std::clamp(grammar->steps, 1, 4);
    auto grown = leaf::Leaf::begin(*grammar, { .final_step = steps, .age = 0.5 });
    if (!is_read(grown))
        return 0;
    for (int i = 0; i < steps; ++i)
        if (!is_read(grown->derive()))
            return 0;
    is_read(grown->fill());
    return 0;
}
